// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/render/png.h"

#include <vtkImageShrink3D.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

namespace powderlink::render {

std::string png_of(vtkRenderWindow* window) {
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->SetInputBufferTypeToRGB();
  grab->ReadFrontBufferOff();
  vtkNew<vtkImageShrink3D> average;
  average->SetInputConnection(grab->GetOutputPort());
  average->SetShrinkFactors(kOversampling, kOversampling, 1);
  average->MeanOn();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(average->GetOutputPort());
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  return {reinterpret_cast<const char*>(bytes->GetPointer(0)),
          static_cast<std::size_t>(bytes->GetNumberOfValues())};
}

}  // namespace powderlink::render
