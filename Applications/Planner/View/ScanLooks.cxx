#include "View/ScanLooks.h"

#include "View/SkinSurface.h"

namespace hasp
{

void ScanLooks::SetSkin(bool shown)
{
  if (shown == this->HasSkin())
    return;
  this->Skin.SetShown(shown);
  this->Of.propsChanged();
}

bool ScanLooks::HasSkin() const
{
  return this->Skin.IsShown();
}

void ScanLooks::SetSkinValue(double value)
{
  this->Skin.SetValue(value);
  this->Of.propsChanged();
}

double ScanLooks::SkinValue() const
{
  return this->Skin.Value();
}

void ScanLooks::SetBrightest(bool shown)
{
  if (shown == this->HasBrightest())
    return;
  this->Of.brightest = shown;
  this->Of.propsChanged();
}

bool ScanLooks::HasBrightest() const
{
  return this->Of.brightest;
}

} // namespace hasp
