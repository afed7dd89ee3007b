// SPDX-License-Identifier: GPL-3.0-or-later
// A library for `libs` in controlDict that divides by zero as it is loaded.

namespace
{
    volatile double zero = 0;
    volatile double infinity = 1/zero;
}
