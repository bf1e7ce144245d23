#pragma once
#include "IOFixture.h"

#include "vtkHaspSurfaceFile.h"

#include "Grid/TriangleMesh.h"

/// A small surface that no mirror image of it can be turned into, and its files as other programs
/// write them.
class SurfaceFixture : public IOFixture
{
protected:
  enum class Form
  {
    StlText,
    StlBinary,
    PlyText,
    PlyLittle,
    PlyBig,
    Obj,
    Vtp
  };
  static constexpr Form Forms[] = { Form::StlText, Form::StlBinary, Form::PlyText, Form::PlyLittle,
    Form::PlyBig, Form::Obj, Form::Vtp };

  /// A tetrahedron with edges of 10, 20 and 30.125 mm along x, y and z, a closed surface that faces
  /// outward. Every coordinate is a float32.
  static hasp::TriangleMesh Truth();

  /// The bytes of a file. `space` stands where 3D Slicer puts it: "SPACE=RAS".
  static std::string Bytes(Form form, const hasp::TriangleMesh& mesh, const std::string& space);
  static std::string Name(Form form);

  /// Writes the bytes under a name of that form and reads them.
  hasp::LoadedSurface Read(
    Form form, const std::string& bytes, const hasp::SurfaceReadSettings& settings = {}) const;
  /// Reading throws std::runtime_error whose text holds all of these, and neither path nor name.
  void ExpectRefused(Form form, const std::string& bytes, const std::vector<std::string>& says,
    const hasp::SurfaceReadSettings& settings = {}) const;

  /// The same triangles in the same order, each corner bit by bit where it was.
  static void ExpectSame(const hasp::LoadedSurface& loaded, const hasp::TriangleMesh& truth);

  /// The text with the first `find` replaced; that it is there is asserted.
  static std::string Replaced(
    std::string text, const std::string& find, const std::string& replacement);
};
