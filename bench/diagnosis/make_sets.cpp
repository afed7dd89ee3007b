// SPDX-License-Identifier: GPL-3.0-or-later
// make_sets FOLDER SEED COUNT [KIND | KIND=COUNT ...]: drop tests with a hidden effect, COUNT of every
// kind or of those named, for the study of the diagnosis (docs/diagnosis.md). Shares no code with powderlink: closed energy and force
// balances of one sphere, written here, with laws of the same families in other forms:
//
//   none       1/2 m v^2 = W,  W = 11.69 (Gamma^5 R^4/E*^2)^(1/3)
//   finite_stop_pulse          m (A + g) = 1.5 pi Gamma R; peak A of a triangle, sin^2, trapezoid or
//                              one-sided sawtooth pulse
//   rate_dependent_adhesion    Gamma times 1 + (w/w*)^n or 1 + c ln(1 + w/w*), w = v a0/(2 delta0)
//   electrostatic_image_force  image of a dielectric plate, cut off at some radii, or with a patch
//   capillary_bridge           constant, triangular or exponential force up to rupture
//   surface_roughness          Gamma / (1 + (R/r)^p) or Gamma / sqrt(1 + (R/r)^2)
//   plastic_contact            a gradual change to the flattened contact, exponent 1.2 to 1.8
//   psd_cutoff                 a soft limit: (d^-q + d_max^-q)^(-1/q), q = 12 to 40
//   adhesion_scatter           the other sets are critical diameters; here retained shares of 8 to 12
//                              size classes at one speed, Gamma gamma-distributed, binomial counts
//   step, wave                 outside the catalogue: a jump at some speed, a sine in v
//
// Every set: 6 to 15 rows between 0.5 and 8 m/s, noise of 1 to 6 %, sigma stated in four of five. An
// effect must be there to be found: without noise the best baseline is off by at least four times the
// noise (rms); with less, its shape drowns. Writes set_NNNN.csv, set_NNNN.toml and truth.csv.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kVacuum_F_m = 8.8541878128e-12;
constexpr double kGravity = 9.81;
constexpr double kLeastDeparture = 4.0;  // of the noise
constexpr double kSmallest_m = 4e-6, kLargest_m = 450e-6;

class Random {  // splitmix64
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  double uniform(double low, double high) { return low + (high - low) * unit(); }
  double logarithmic(double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
  }
  int integer(int low, int high) {  // both included
    return low + static_cast<int>(unit() * (high - low + 1));
  }
  double normal() {
    const double u = 1.0 - unit();
    return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * kPi * unit());
  }

 private:
  double unit() {
    state_ += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return static_cast<double>((z ^ (z >> 31)) >> 11) / 9007199254740992.0;
  }
  std::uint64_t state_;
};

struct Solid {
  const char* name;
  double density, modulus, poisson;
};
const std::vector<Solid> kGrains = {{"316L", 7980, 2.11e11, 0.3},
                                    {"glass", 2510, 7.3e10, 0.2},
                                    {"Ti-6Al-4V", 4430, 1.14e11, 0.34},
                                    {"tungsten carbide", 15600, 6e11, 0.22},
                                    {"alumina", 3950, 3.7e11, 0.22}};
const std::vector<Solid> kPlates = {{"glass", 2510, 7.3e10, 0.2},
                                    {"UPVC", 1440, 3.0e9, 0.3},
                                    {"steel", 7850, 2.1e11, 0.3},
                                    {"PMMA", 1190, 3.2e9, 0.37}};

struct Pair {
  Solid grain, plate;
  double modulus() const {
    return 1 / ((1 - grain.poisson * grain.poisson) / grain.modulus +
                (1 - plate.poisson * plate.poisson) / plate.modulus);
  }
  double mass(double radius) const { return 4.0 / 3.0 * kPi * std::pow(radius, 3) * grain.density; }
  double work(double gamma, double radius) const {
    return 11.69 * std::cbrt(std::pow(gamma, 5) * std::pow(radius, 4) / std::pow(modulus(), 2));
  }
  /// Gamma of an instant stop with this critical radius.
  double gamma_for(double radius, double v) const {
    const double s = 0.5 * mass(radius) * v * v / 11.69;
    return std::pow(s * s * s * std::pow(modulus(), 2) / std::pow(radius, 4), 0.2);
  }
};

/// Holding less pulling, over radius: the largest radius that stays is where it changes sign.
double critical_radius(const std::function<double(double)>& holds_by) {
  double low = kSmallest_m / 20;
  double high = kLargest_m * 20;
  if (holds_by(low) < 0 || holds_by(high) > 0) throw std::range_error("no critical radius");
  for (int i = 0; i < 80; ++i) {
    const double middle = std::sqrt(low * high);
    (holds_by(middle) > 0 ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

using Law = std::function<double(double v)>;  ///< critical radius [m]

/// A drop of medium speed leaves grains of this radius; every law is scaled to it.
struct Scene {
  Pair pair;
  double v_low, v_high, v_mid, radius_mid;
};

Law instant(
    const Scene& s, const std::function<double(double radius, double v)>& gamma,
    const std::function<double(double radius)>& more_work = [](double) { return 0.0; }) {
  return [=](double v) {
    return critical_radius([&](double r) {
      return s.pair.work(gamma(r, v), r) + more_work(r) - 0.5 * s.pair.mass(r) * v * v;
    });
  };
}

Law none(const Scene& s, Random&) {
  const double gamma = s.pair.gamma_for(s.radius_mid, s.v_mid);
  return instant(s, [=](double, double) { return gamma; });
}

Law finite_stop(const Scene& s, Random& random) {
  const double tau = random.logarithmic(3e-5, 2.5e-4);
  const double rebound = random.uniform(0.0, 0.7);
  const double rise = random.uniform(0.2, 0.45);
  const double shapes[] = {2.0, 2.0, 1 / (1 - rise), 2.0 + rise};
  const double peak = shapes[random.integer(0, 3)];
  const double mid = peak * s.v_mid * (1 + rebound) / tau + kGravity;
  const double gamma = 8.0 / 9.0 * s.pair.grain.density * mid * s.radius_mid * s.radius_mid;
  return [=](double v) {
    const double a = peak * v * (1 + rebound) / tau + kGravity;
    return std::sqrt(9 * gamma / (8 * s.pair.grain.density * a));
  };
}

Law rate(const Scene& s, Random& random) {
  const bool logarithm = random.integer(0, 2) == 0;
  const double n = random.uniform(0.15, 0.5);
  const double c = random.uniform(0.2, 2.0);
  const double speed = random.logarithmic(1e-3, 0.3);
  const double e = s.pair.modulus();
  const auto growth = [=](double gamma, double radius, double v) {
    const double a0 = std::cbrt(4.5 * kPi * gamma * radius * radius / e);
    const double w = v * a0 / (2 * a0 * a0 / (3 * radius));
    return logarithm ? 1 + c * std::log1p(w / speed) : 1 + std::pow(w / speed, n);
  };
  const double full = s.pair.gamma_for(s.radius_mid, s.v_mid);
  double gamma = full;
  for (int i = 0; i < 60; ++i) gamma = full / growth(gamma, s.radius_mid, s.v_mid);
  return instant(s, [=](double r, double v) { return gamma * growth(gamma, r, v); });
}

Law image_force(const Scene& s, Random& random) {
  const double stop_speed = s.v_low * random.uniform(0.45, 0.93);
  const int form = random.integer(0, 2);
  const double reach = random.uniform(2.0, 8.0);
  const double share = random.uniform(0.3, 1.0);
  // Energy of the charge over R^3, from the speed below which nothing leaves.
  const double u = 0.5 * 4.0 / 3.0 * kPi * s.pair.grain.density * stop_speed * stop_speed;
  const auto charge_work = [=](double r) {
    if (form == 1) return u * r * r * r * (1 - 1 / (1 + reach));
    if (form == 2) return u * r * r * r * (share + (1 - share) * std::pow(r / s.radius_mid, -0.15));
    return u * r * r * r;
  };
  const double rest =
      0.5 * s.pair.mass(s.radius_mid) * s.v_mid * s.v_mid - charge_work(s.radius_mid);
  if (rest <= 0) throw std::range_error("all charge");
  const double v_rest = std::sqrt(2 * rest / s.pair.mass(s.radius_mid));
  const double gamma = s.pair.gamma_for(s.radius_mid, v_rest);
  return instant(
      s, [=](double, double) { return gamma; }, charge_work);
}

Law bridge(const Scene& s, Random& random) {
  const double share = random.uniform(0.35, 0.97);  // of the work at medium speed
  const int form = random.integer(0, 2);
  const double total = 0.5 * s.pair.mass(s.radius_mid) * s.v_mid * s.v_mid;
  // Force ~ R over a length ~ R (constant or triangular), or over one that depends on size weakly.
  const double power = form == 2 ? 2.0 - random.uniform(0.0, 0.2) : 2.0;
  const double more = share * total / std::pow(s.radius_mid, power);
  const double v_rest = std::sqrt(2 * (1 - share) * total / s.pair.mass(s.radius_mid));
  const double gamma = s.pair.gamma_for(s.radius_mid, v_rest);
  return instant(
      s, [=](double, double) { return gamma; },
      [=](double r) { return more * std::pow(r, power); });
}

Law roughness(const Scene& s, Random& random) {
  const double asperity = s.radius_mid * random.logarithmic(0.1, 2.0);
  const double power = random.uniform(0.8, 1.1);
  const bool root = random.integer(0, 2) == 0;
  const auto factor = [=](double r) {
    return root ? 1 / std::sqrt(1 + std::pow(r / asperity, 2))
                : 1 / (1 + std::pow(r / asperity, power));
  };
  const double gamma = s.pair.gamma_for(s.radius_mid, s.v_mid) / factor(s.radius_mid);
  return instant(s, [=](double r, double) { return gamma * factor(r); });
}

Law plastic(const Scene& s, Random& random) {
  // Grains below this radius yield: R_p/R = (r_y/R)^(x/3), gradual over m.
  const double yields_below = s.radius_mid * random.logarithmic(0.8, 8.0);
  const double x = random.uniform(1.3, 1.7);
  const double m = random.uniform(4.0, 12.0);
  const auto factor = [=](double r) {
    return std::pow(1 + std::pow(yields_below / r, m / 3), x / m);
  };
  const double gamma = s.pair.gamma_for(s.radius_mid, s.v_mid) / factor(s.radius_mid);
  return instant(s, [=](double r, double) { return gamma * factor(r); });
}

Law cutoff(const Scene& s, Random& random) {
  const Law free = none(s, random);
  const double v_cut = s.v_low * std::pow(s.v_high / s.v_low, random.uniform(0.25, 0.75));
  const double largest = free(v_cut);
  const double q = random.logarithmic(12, 40);
  return [=](double v) { return std::pow(std::pow(free(v), -q) + std::pow(largest, -q), -1 / q); };
}

Law step(const Scene& s, Random& random) {
  const Law free = none(s, random);
  const double height = random.uniform(0.15, 0.5) * (random.integer(0, 1) == 0 ? 1 : -0.8);
  const double at = s.v_low + (s.v_high - s.v_low) * random.uniform(0.25, 0.75);
  return [=](double v) { return free(v) * (v > at ? 1 + height : 1); };
}

Law wave(const Scene& s, Random& random) {
  const Law free = none(s, random);
  const double height = random.uniform(0.12, 0.35);
  const double length = (s.v_high - s.v_low) / random.uniform(1.0, 2.5);
  const double phase = random.uniform(0, 2 * kPi);
  return [=](double v) { return free(v) * (1 + height * std::sin(2 * kPi * v / length + phase)); };
}

const std::vector<std::pair<std::string, Law (*)(const Scene&, Random&)>> kKinds = {
    {"none", none},
    {"finite_stop_pulse", finite_stop},
    {"rate_dependent_adhesion", rate},
    {"electrostatic_image_force", image_force},
    {"capillary_bridge", bridge},
    {"surface_roughness", roughness},
    {"plastic_contact", plastic},
    {"psd_cutoff", cutoff},
    {"adhesion_scatter", nullptr},
    {"step", step},
    {"wave", wave}};

struct Set {
  Scene scene;
  double noise;
  bool stated;
  std::vector<double> v, d;
};

/// rms of ln d against the best baseline, without noise.
double departure(const std::vector<double>& v, const std::vector<double>& d) {
  double mean = 0;
  double square = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const double y = std::log(d[i]) + 1.2 * std::log(v[i]);
    mean += y / static_cast<double>(v.size());
    square += y * y / static_cast<double>(v.size());
  }
  return std::sqrt(std::fmax(0, square - mean * mean));
}

Set make(Law (*kind)(const Scene&, Random&), bool hidden, Random& random) {
  while (true) {
    Set set;
    Scene& s = set.scene;
    s.pair = {kGrains[static_cast<std::size_t>(random.integer(0, 4))],
              kPlates[static_cast<std::size_t>(random.integer(0, 3))]};
    s.v_low = random.logarithmic(0.5, 1.8);
    s.v_high = std::fmin(8.0, s.v_low * random.uniform(3.0, 8.0));
    s.v_mid = std::sqrt(s.v_low * s.v_high);
    s.radius_mid = random.logarithmic(12e-6, 35e-6);
    set.noise = random.uniform(0.01, 0.06);
    set.stated = random.integer(0, 4) > 0;
    const int rows = random.integer(6, 15);
    const bool even = random.integer(0, 1) == 0;
    try {
      const Law law = kind(s, random);
      bool usable = true;
      for (int i = 0; i < rows; ++i) {
        const double t = static_cast<double>(i) / (rows - 1);
        const double v =
            even ? s.v_low + t * (s.v_high - s.v_low) : s.v_low * std::pow(s.v_high / s.v_low, t);
        set.v.push_back(std::round(1000 * v) / 1000);
        set.d.push_back(2 * law(set.v.back()));
        usable = usable && set.d.back() > kSmallest_m && set.d.back() < kLargest_m;
      }
      if (!usable) continue;
    } catch (const std::range_error&) {
      continue;
    }
    if (hidden && departure(set.v, set.d) < kLeastDeparture * set.noise) continue;
    for (double& d : set.d) d *= 1 + set.noise * random.normal();
    return set;
  }
}

void write_study(const Pair& pair, const std::filesystem::path& folder, const std::string& name,
                 const char* experiment) {
  std::ofstream toml(folder / (name + ".toml"));
  const auto material = [&](const char* table, const Solid& m) {
    toml << "[" << table << "]  # " << m.name << "\ndensity_kg_m3 = " << m.density
         << "\nyoungs_modulus_Pa = " << m.modulus << "\npoissons_ratio = " << m.poisson << "\n";
  };
  toml << "[study]\nname = \"" << name << "\"\nexperiment = \"" << experiment
       << "\"\nmeasurements = \"" << name << ".csv\"\n";
  material("particle", pair.grain);
  material("substrate", pair.plate);
  toml << "[model]\neffects = []\n[fit]\nadhesive_energy_J_m2 = [0.001, 1000.0]\n";
}

/// Counts of one drop: 40 to 200 grains per class; Gamma spreads by a gamma distribution.
void write_shares(Random& random, const std::filesystem::path& folder, const std::string& name) {
  const Pair pair = {kGrains[static_cast<std::size_t>(random.integer(0, 4))],
                     kPlates[static_cast<std::size_t>(random.integer(0, 3))]};
  const double v = random.logarithmic(0.8, 5.0);
  const double middle = random.logarithmic(20e-6, 70e-6);
  const double gamma = pair.gamma_for(0.5 * middle, v);
  const int shape = random.integer(2, 14);  // relative spread 1/sqrt(shape)
  const int classes = random.integer(8, 12);
  const int grains = random.integer(40, 200);
  std::ofstream csv(folder / (name + ".csv"));
  csv << "impact_velocity_m_s,diameter_um,diameter_low_um,diameter_high_um,count_before,"
         "count_after\n";
  const double low = 0.35 * middle;
  const double width = std::pow(8.0, 1.0 / classes);
  for (int i = 0; i < classes; ++i) {
    const double from = low * std::pow(width, i);
    int stayed = 0;
    for (int j = 0; j < grains; ++j) {
      double spread = 0;  // sum of exponentials, mean 1
      for (int k = 0; k < shape; ++k) spread -= std::log(1 - random.uniform(0, 1)) / shape;
      const double r = 0.5 * from * std::pow(width, random.uniform(0, 1));
      stayed += pair.work(gamma * spread, r) > 0.5 * pair.mass(r) * v * v ? 1 : 0;
    }
    char line[160];
    std::snprintf(line, sizeof line, "%g,%.3f,%.3f,%.3f,%d,%d\n", v, 1e6 * from * std::sqrt(width),
                  1e6 * from, 1e6 * from * width, grains, stayed);
    csv << line;
  }
  write_study(pair, folder, name, "kat_retention");
}

void write(const Set& set, const std::filesystem::path& folder, const std::string& name) {
  std::ofstream csv(folder / (name + ".csv"));
  csv << "impact_velocity_m_s,critical_diameter_um"
      << (set.stated ? ",critical_diameter_sigma_um\n" : "\n");
  char line[96];
  for (std::size_t i = 0; i < set.v.size(); ++i) {
    const double d = set.d[i] * 1e6;
    std::snprintf(line, sizeof line, "%g,%.3f", set.v[i], d);
    csv << line;
    std::snprintf(line, sizeof line, ",%.4f", d * set.noise);
    csv << (set.stated ? line : "") << "\n";
  }
  write_study(set.scene.pair, folder, name, "kat_critical_diameter");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "make_sets FOLDER SEED COUNT [KIND | KIND=COUNT ...]\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  Random random(std::strtoull(argv[2], nullptr, 10));
  const int count = std::atoi(argv[3]);
  std::map<std::string, int> wanted;
  for (int i = 4; i < argc; ++i) {
    const std::string word = argv[i];
    const std::size_t equals = word.find('=');
    wanted[word.substr(0, equals)] =
        equals == std::string::npos ? count : std::atoi(word.c_str() + equals + 1);
  }
  std::filesystem::create_directories(folder);
  std::ofstream truth(folder / "truth.csv");
  truth << "set,hidden,noise,sigma_stated,rows\n";
  int number = 0;
  for (const auto& [name, law] : kKinds) {
    const int of_kind = wanted.empty() ? count : wanted[name];
    for (int i = 0; i < of_kind; ++i) {
      char file[16];
      std::snprintf(file, sizeof file, "set_%04d", ++number);
      if (law == nullptr) {
        write_shares(random, folder, file);
        truth << file << "," << name << ",,,\n";
        continue;
      }
      const Set set = make(law, name != "none", random);
      write(set, folder, file);
      truth << file << "," << name << "," << set.noise << "," << (set.stated ? 1 : 0) << ","
            << set.v.size() << "\n";
    }
  }
  return truth.good() ? 0 : 1;
}
