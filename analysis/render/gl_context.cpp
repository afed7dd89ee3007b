// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/render/gl_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <vtkGenericOpenGLRenderWindow.h>

#include <array>
#include <cstdlib>

#include "analysis/render/glew_without_display.h"
#include "base/invalid_input.h"

namespace powderlink::render {
namespace {

EGLDisplay surfaceless() {
  const auto get = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (get == nullptr) return EGL_NO_DISPLAY;
  return get(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
}

EGLDisplay first_device() {
  const auto get = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      eglGetProcAddress("eglGetPlatformDisplayEXT"));
  const auto list =
      reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  EGLDeviceEXT device = nullptr;
  EGLint count = 0;
  if (get == nullptr || list == nullptr || list(1, &device, &count) == EGL_FALSE || count < 1) {
    return EGL_NO_DISPLAY;
  }
  return get(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
}

EGLDisplay default_display() { return eglGetDisplay(EGL_DEFAULT_DISPLAY); }

}  // namespace

struct GlContext::Handles {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  EGLSurface surface = EGL_NO_SURFACE;

  bool start(EGLDisplay candidate) {
    if (candidate == EGL_NO_DISPLAY || eglInitialize(candidate, nullptr, nullptr) == EGL_FALSE) {
      return false;
    }
    display = candidate;
    const std::array<EGLint, 11> wanted = {EGL_SURFACE_TYPE,
                                           EGL_PBUFFER_BIT,
                                           EGL_RENDERABLE_TYPE,
                                           EGL_OPENGL_BIT,
                                           EGL_RED_SIZE,
                                           8,
                                           EGL_GREEN_SIZE,
                                           8,
                                           EGL_BLUE_SIZE,
                                           8,
                                           EGL_NONE};
    const std::array<EGLint, 5> version = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION,
                                           2, EGL_NONE};
    const std::array<EGLint, 5> tiny = {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint configs = 0;
    if (eglBindAPI(EGL_OPENGL_API) == EGL_TRUE &&
        eglChooseConfig(display, wanted.data(), &config, 1, &configs) == EGL_TRUE && configs > 0) {
      context = eglCreateContext(display, config, EGL_NO_CONTEXT, version.data());
      surface = eglCreatePbufferSurface(display, config, tiny.data());
      if (context != EGL_NO_CONTEXT &&
          eglMakeCurrent(display, surface, surface, context) == EGL_TRUE) {
        return true;
      }
    }
    stop();
    return false;
  }

  void stop() {
    if (display == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (surface != EGL_NO_SURFACE) eglDestroySurface(display, surface);
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    // No eglTerminate: a display is one per process, and Mesa forgets memory when it is unloaded.
    display = EGL_NO_DISPLAY;
    context = EGL_NO_CONTEXT;
    surface = EGL_NO_SURFACE;
  }
};

GlContext::GlContext() : handles_(std::make_unique<Handles>()) {
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 0);  // NOLINT(concurrency-mt-unsafe)
  if (!handles_->start(surfaceless()) && !handles_->start(first_device()) &&
      !handles_->start(default_display())) {
    throw InvalidInput("drawing without a display", "EGL offers no OpenGL 3.2 context",
                       "Mesa's software renderer or a graphics driver with EGL",
                       "install libegl1, libegl-mesa0 and libgl1-mesa-dri");
  }
}

GlContext::~GlContext() { handles_->stop(); }

vtkSmartPointer<vtkRenderWindow> GlContext::make_window(int width_px, int height_px) const {
  accept_glew_without_display();
  auto window = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
  window->SetOwnContext(0);
  window->SetIsCurrent(true);
  window->SetIsDirect(1);
  window->SetSupportsOpenGL(1);
  window->SetReadyForRendering(true);
  window->SetShowWindow(false);
  window->SetUseOffScreenBuffers(true);
  window->SetMultiSamples(4);
  window->SetSize(width_px, height_px);
  return window;
}

}  // namespace powderlink::render
