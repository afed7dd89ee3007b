// SPDX-License-Identifier: GPL-3.0-or-later
/// \file device_rows.h
/// Drops of the KAT device as rows of a study: what `powderlink compare` and `diagnose` read.
/// Tests: tests/analysis/kat/kat_device_test.cpp
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/kat/device/device_velocity.h"
#include "analysis/kat/device/drop_log.h"
#include "physics/contact/material.h"

namespace powderlink::analysis {

struct DeviceRow {
  LoggedDrop source;
  DeviceVelocity velocity;
  std::optional<double> contact_time_us{};       ///< of the first contact
  std::optional<double> critical_diameter_um{};  ///< from the microscope; the device knows none
  std::optional<double> critical_diameter_sigma_um{};
};

struct DeviceRows {
  std::vector<DeviceRow> rows;     ///< drops without fault
  std::vector<std::string> notes;  ///< faults with what to do, times that do not agree, repetitions
};

/// A report that is in `drops` again, identical in all fields, is one drop.
/// \param diameters_um, sigmas_um  none, or one per drop without fault, in order; sigmas may be one
///                                 for all
DeviceRows device_rows(const std::vector<LoggedDrop>& drops, const DeviceSigmas& sigmas,
                       const std::vector<double>& diameters_um,
                       const std::vector<double>& sigmas_um);

std::string device_table(const std::vector<DeviceRow>& rows);  ///< for the terminal
/// Measurement table; without diameters a list of drops only.
std::string device_csv(const std::vector<DeviceRow>& rows);
/// A study of these rows; `csv` as the study names it, used when the rows have diameters.
std::string device_study(const std::vector<DeviceRow>& rows, const std::string& name,
                         const std::string& csv, const physics::Material& particle,
                         const physics::Material& substrate);

}  // namespace powderlink::analysis
