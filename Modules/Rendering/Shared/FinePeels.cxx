#include "FinePeels.h"

#include "HaspGL.h"

#include "vtkDualDepthPeelingPass.h"
#include "vtkTextureObject.h"

#include <cstdint>
#include <vector>

namespace
{

/// What VTK has for classes derived from its pass.
class PeelingPass : public vtkDualDepthPeelingPass
{
public:
  /// The depths come first, when none of the colours says anything yet.
  static bool Begins(vtkDualDepthPeelingPass* pass)
  {
    return pass->*(&PeelingPass::CurrentStage) == InitializingDepth;
  }
  static std::vector<vtkTextureObject*> Colors(vtkDualDepthPeelingPass* pass)
  {
    const auto& all = pass->*(&PeelingPass::Textures);
    return { all[BackTemp], all[Back], all[FrontA], all[FrontB] };
  }
};

} // namespace

void UseFinePeels(vtkOpenGLRenderPass* pass)
{
  auto* peeling = vtkDualDepthPeelingPass::SafeDownCast(pass);
  if (!peeling || !PeelingPass::Begins(peeling))
    return;
  GLint bound = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound); // the pass's own, in use
  for (vtkTextureObject* texture : PeelingPass::Colors(peeling))
  {
    if (texture->GetVTKDataType() == VTK_UNSIGNED_SHORT)
      continue;
    // VTK has cleared them, and the new ones are clear, too.
    std::vector<std::uint16_t> clear(std::size_t(4) * texture->GetWidth() * texture->GetHeight());
    texture->ResetFormatAndType();
    texture->SetFormat(GL_RGBA);
    texture->SetInternalFormat(GL_RGBA16);
    texture->Create2DFromRaw(
      texture->GetWidth(), texture->GetHeight(), 4, VTK_UNSIGNED_SHORT, clear.data());
  }
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(bound));
}
