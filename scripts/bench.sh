#!/usr/bin/env bash
# scripts/bench.sh [contact | kat | reduced | laboratory | pipe]...: benchmarks side by side with the peers, as ratios.
# Quote medians of a quiet machine; nothing here is a test.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
launcher=$PWD/build/bin/liggghts-powderlink

contact() {
  echo "Contact model: 10 000 grains held on a plane (limit: jkr 1.3 times stock hertz, aim 1.1)"
  bench/contact/run.sh "$launcher"
}
kat() {
  echo "Kinetic Adhesion Test, one core"
  bench/kat/run.sh "$launcher"
}
reduced() {
  echo "Reduced model: one critical diameter (limit 5 ms)"
  build/bench_bin/reduced_model_bench --benchmark_min_time=0.5
}
pipe() {
  echo "Pipe, case A, 16 600 grains, from the filled state (limit 5 s per simulated ms)"
  POWDERLINK_BIN=$PWD/build/bin bench/pipe/run.sh
}

laboratory() {
  echo "Particle sizes and critical diameter, processor time"
  bench/laboratory/run.sh build/bin/powderlink build/test_bin/draw_spheres
}

parts=("$@")
[[ ${#parts[@]} -gt 0 ]] || parts=(contact kat reduced laboratory pipe)
for part in "${parts[@]}"; do
  case $part in
    contact | kat | reduced | laboratory | pipe) "$part" && echo ;;
    *)
      echo "bench; given: $part; allowed: contact, kat, reduced, laboratory, pipe; to do: ./powderlink bench [PART]..." >&2
      exit 2
      ;;
  esac
done
