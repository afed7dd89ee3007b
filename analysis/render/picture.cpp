// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/render/picture.h"

#include <fmt/format.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/render/frame_choice.h"
#include "analysis/render/gl_context.h"
#include "analysis/render/legend.h"
#include "analysis/render/png.h"
#include "analysis/render/scene.h"
#include "base/files/write_file.h"
#include "base/invalid_input.h"

namespace powderlink::render {
namespace {

constexpr double kFallShare = 0.7;  ///< of the depth, for the fastest grain of the last picture
constexpr int kFlightStates = 24;

/// What is drawn: states in order, and the one that says where the grains sat.
struct Content {
  State before;
  std::vector<State> shown;
  ViewWindow window;
  double speed_scale = 1.0;
  std::size_t columns() const { return shown.size(); }
};

void check(const PictureOptions& options) {
  const auto refuse = [](const char* option, const std::string& given, const char* allowed) {
    throw InvalidInput(std::string("option ") + option, given, allowed, "correct the option");
  };
  if (options.width_px < 400 || options.width_px > 8000) {
    refuse("--width", std::to_string(options.width_px), "400 to 8000 pixels");
  }
  if (options.frames < 1 || options.frames > 6) {
    refuse("--frames", std::to_string(options.frames), "1 to 6");
  }
  if (options.window_um && !(*options.window_um > 0.0 && std::isfinite(*options.window_um))) {
    refuse("--window", std::to_string(*options.window_um), "um above 0");
  }
  if (options.flight_s && !(*options.flight_s >= 0.0 && std::isfinite(*options.flight_s))) {
    refuse("--flight", std::to_string(*options.flight_s), "seconds, 0 for none");
  }
}

std::size_t nearest_state(const RunDirectory& run, double time_s) {
  const double first = run.time_s(run.particles.front().step);
  const double last = run.time_s(run.particles.back().step);
  const double slack = 1e-9 * std::max(std::abs(last), 1e-12);
  if (!(time_s >= first - slack && time_s <= last + slack)) {
    throw InvalidInput("option --time", fmt::format("{:g} s", time_s),
                       fmt::format("{:g} to {:g} s, what the run has dumped", first, last),
                       "give a time of the run");
  }
  std::size_t best = 0;
  for (std::size_t i = 0; i < run.particles.size(); ++i) {
    if (std::abs(run.time_s(run.particles[i].step) - time_s) <
        std::abs(run.time_s(run.particles[best].step) - time_s)) {
      best = i;
    }
  }
  return best;
}

Content choose(const RunDirectory& run, const PictureOptions& options) {
  std::vector<State> states;
  for (std::size_t i = 0; i < run.particles.size(); ++i) {
    states.push_back(read_state(run, i, options.fix));
  }
  Content content;
  const std::size_t before = state_before(states);
  if (states[before].grains.empty()) {
    throw InvalidInput("drawing " + run.path.string(), "dumps without particles",
                       "at least one particle", "run the drop test again");
  }
  const bool single = options.last || options.time_s || options.frames == 1;
  const double columns = single ? 19.0 : (options.frames == 2 ? 14.0 : 11.0);
  const double depth = single ? 0.48 : 1.15;
  content.window =
      choose_window(states[before], states.back(), columns, single ? 0.65 : 1.0, depth);
  if (options.window_um) {
    const double factor = *options.window_um / content.window.width_um;
    content.window.width_um *= factor;
    content.window.breadth_um *= factor;
    content.window.depth_um *= factor;
  }
  // Seconds of flight need physical times; a single dumped state is shown as it is.
  if (run.time_step_s && !options.last && !options.time_s) {
    const State last = states.back();
    const double flight = options.flight_s
                              ? *options.flight_s
                              : flight_time_s(last, states[before], content.window, kFallShare);
    for (int i = 1; flight > 0.0 && i <= kFlightStates; ++i) {
      states.push_back(fly(last, flight * i / kFlightStates));
    }
  }
  std::vector<std::size_t> chosen;
  if (options.last) {
    chosen = {states.size() - 1};
  } else if (options.time_s) {
    chosen = {nearest_state(run, *options.time_s)};
  } else {
    chosen = choose_states(states, content.window, static_cast<std::size_t>(options.frames));
  }
  double fastest = 0.0;
  for (const std::size_t i : chosen) {
    for (const Grain& grain : grains_in(states[i], states[before], content.window)) {
      if (!grain.attached) fastest = std::max(fastest, grain.speed_m_s);
    }
    content.shown.push_back(states[i]);
  }
  content.speed_scale = round_scale(fastest);
  content.before = states[before];
  // No more empty paper below than the lowest grain needs.
  double lowest = 0.25 * content.window.width_um;
  for (const State& state : content.shown) {
    for (const Grain& grain : grains_in(state, content.before, content.window)) {
      lowest = std::max(lowest, state.plate_z_um - grain.z_um + 0.5 * grain.diameter_um);
    }
  }
  content.window.depth_um = std::min(content.window.depth_um, lowest);
  return content;
}

std::string title_of(const RunDirectory& run, const PictureOptions& options) {
  if (options.title) return *options.title;
  std::string title = "Kinetic adhesion test";
  if (run.results.impact_velocity_m_s) {
    title += fmt::format(", ~v = {:.2f} m/s", *run.results.impact_velocity_m_s);
  }
  if (run.results.critical_diameter_m) {
    title += fmt::format(", ~d_c = {:.1f} \u00b5m", 1e6 * *run.results.critical_diameter_m);
  }
  return title;
}

std::string time_text(double time_s) {
  if (time_s < 0.9995e-3) return fmt::format("{:.3g} \u00b5s", 1e6 * time_s);
  return fmt::format("{:.3g} ms", 1e3 * time_s);
}

std::string caption_of(const RunDirectory& run, const State& state, std::size_t index,
                       std::size_t count) {
  std::string caption;
  if (count > 1) caption = fmt::format("({})  ", static_cast<char>('a' + index));
  if (run.time_step_s) {
    return caption + "~t = " + time_text(state.clock);
  }
  return caption + fmt::format("step {}", state.step);
}

}  // namespace

void write_picture(const RunDirectory& run, const std::filesystem::path& png,
                   const PictureOptions& options) {
  check(options);
  const Content content = choose(run, options);

  // Sizes in pixels of the oversampled image.
  const double width = kOversampling * options.width_px;
  const double text = 0.0155 * width;
  const double panel_width = width / static_cast<double>(content.columns());
  const double view =
      content.window.width_um > 0.0 ? content.window.depth_um / content.window.width_um : 1.0;
  const double panel_height = panel_width * std::min(1.2, view + 0.2);
  const bool flies = std::any_of(content.shown.begin(), content.shown.end(),
                                 [](const State& state) { return state.flight_s > 0.0; });
  const double captions = (flies ? 4.5 : 3.3) * text;
  const double bottom = 5.6 * text, top = 3.2 * text;
  const double height = std::ceil((bottom + captions + panel_height + top) / 2.0) * 2.0;

  const GlContext gl;
  const auto window = gl.make_window(static_cast<int>(width), static_cast<int>(height));
  window->SetNumberOfLayers(2);
  vtkNew<vtkRenderer> paper;  // behind the panels, so that all gaps are white
  paper->SetBackground(1.0, 1.0, 1.0);
  window->AddRenderer(paper);
  vtkNew<vtkRenderer> layer;
  layer->SetLayer(1);
  std::vector<vtkSmartPointer<vtkRenderer>> scenes;
  for (std::size_t i = 0; i < content.columns(); ++i) {
    const State& state = content.shown[i];
    const auto scene = make_scene(state, content.before, content.window, content.speed_scale,
                                  panel_width / panel_height);
    const double left = panel_width * static_cast<double>(i);
    scene->SetViewport(left / width, (bottom + captions) / height, (left + panel_width) / width,
                       (bottom + captions + panel_height) / height);
    window->AddRenderer(scene);
    scenes.push_back(scene);
    const double middle = left + 0.5 * panel_width;
    draw_text(layer, caption_of(run, state, i, content.columns()),
              {middle, bottom + captions - 1.55 * text}, text, Align::centre, true);
    draw_text(layer,
              fmt::format("{} attached, {} detached", state.attached(),
                          state.grains.size() - state.attached()),
              {middle, bottom + captions - 2.95 * text}, 0.9 * text, Align::centre);
    if (state.flight_s > 0.0) {
      draw_text(layer, "free flight since " + time_text(state.clock - state.flight_s),
                {middle, bottom + captions - 4.25 * text}, 0.8 * text, Align::centre);
    }
  }
  window->AddRenderer(layer);
  draw_text(layer, title_of(run, options), {0.5 * width, height - 2.1 * text}, 1.25 * text,
            Align::centre, true);
  draw_colour_key(layer, {0.05 * width, 2.0 * text}, 0.58 * width, content.speed_scale, text);
  draw_scale_bar(layer, {0.95 * width, 2.3 * text},
                 pixels_per_um(scenes.front(), content.shown.front(), content.window), 0.16 * width,
                 text);
  window->Render();
  write_file(png, png_of(window));
}

}  // namespace powderlink::render
