#pragma once

namespace hasp
{

class SkinSurface;
class ViewLight;
struct SceneContext;

/// How the scan is shown besides its bone, as the user has it: of whichever plan, off at first. The
/// scene makes and releases what is switched at once. Threads: RENDER.
class ScanLooks
{
public:
  /// All outlive this.
  ScanLooks(SceneContext& of, SkinSurface& skin, ViewLight& light) : Of(of), Skin(skin), Lit(light)
  {
  }

  /// Of all that the view shows.
  ViewLight& Light() const { return this->Lit; }

  ///@{
  /// Translucent, over bone.
  void SetSkin(bool shown);
  bool HasSkin() const;
  ///@}
  ///@{
  /// Where the shown volume's skin begins, in its values.
  void SetSkinValue(double value);
  double SkinValue() const;
  ///@}
  ///@{
  /// The brightest value along each line of sight, instead of the scan's isosurface.
  void SetBrightest(bool shown);
  bool HasBrightest() const;
  ///@}

private:
  SceneContext& Of;
  SkinSurface& Skin;
  ViewLight& Lit;
};

} // namespace hasp
