#include "SurfaceFixture.h"

#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkPolyData.h"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <random>

namespace
{

/// Files that were cut off or changed at random.
class SurfaceHostile : public SurfaceFixture
{
protected:
  enum class Outcome
  {
    Refused,
    Warned, ///< read, and the passport says that it may be cut off
    Read
  };
  Outcome Try(Form form, const std::string& bytes) const
  {
    try
    {
      const auto loaded = this->SurfaceFixture::Read(form, bytes);
      // Throws if a triangle names a point that is not there.
      const hasp::TriangleMesh mesh = hasp::MakeTriangleMesh(loaded.surface);
      for (const glm::uvec3& t : mesh.triangles)
        for (int c = 0; c < 3; ++c)
          if (!(std::abs(mesh.points.at(t[c]).x) <= 1e6))
            throw std::logic_error("a point is nowhere");
      for (const std::string& warning : loaded.passport.warnings)
        if (warning.find("cut off") != warning.npos)
          return Outcome::Warned;
      return Outcome::Read;
    }
    catch (const std::runtime_error&)
    {
      return Outcome::Refused;
    }
  }

  /// One to four changes: a byte, a run left out or doubled, a number that lies, an end.
  static std::string Mutated(std::string bytes, std::mt19937& random)
  {
    static const std::string lies[] = { "4294967295", "-1", "18446744073709551615", "1e308", "nan",
      "0", "-2147483648", "inf", "\xFF\xFF\xFF\xFF", std::string(4, '\0'), "\n", "\\\n", "/" };
    for (int changes = 1 + random() % 4; changes > 0 && !bytes.empty(); --changes)
    {
      const std::size_t at = random() % bytes.size();
      const std::size_t run = std::min<std::size_t>(1 + random() % 20, bytes.size() - at);
      switch (random() % 6)
      {
        case 0:
          bytes[at] = static_cast<char>(random());
          break;
        case 1:
          bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
          break;
        case 2:
          bytes.erase(at, run);
          break;
        case 3:
          bytes.insert(at, bytes.substr(at, run));
          break;
        case 4:
          bytes.replace(at, run, lies[random() % std::size(lies)]);
          break;
        default:
          if (random() % 8 == 0)
            bytes.resize(at);
      }
    }
    return bytes;
  }

  /// Reads mutated files in a process of its own: 0 if each was read or refused.
  int Mutate(Form form, int files) const
  {
    const pid_t child = fork();
    if (child == 0)
    {
      alarm(60); // a hang ends as a signal
      std::mt19937 random(1000 + int(form));
      const std::string sound = Bytes(form, Truth(), "SPACE=RAS");
      int read = 0, n = 0;
      try
      {
        for (; n < files; ++n)
          read += this->Try(form, Mutated(sound, random)) != Outcome::Refused;
      }
      catch (const std::exception& error)
      {
        std::fprintf(stderr, "form %d, file %d: %s\n", int(form), n, error.what());
        _exit(1);
      }
      std::printf(
        "form %d: %d of %d mutated files were read, the others refused\n", int(form), read, files);
      std::fflush(stdout);
      // Else the changes were so coarse that nothing behind the first check was met.
      _exit(read * 100 > files && read * 100 < files * 99 ? 0 : 2);
    }
    int status = -1;
    waitpid(child, &status, 0);
    return status;
  }
  /// HASP_MUTATIONS asks for more than a test has time for.
  static int Files(int usual)
  {
    const char* asked = std::getenv("HASP_MUTATIONS");
    return asked ? std::atoi(asked) : usual;
  }
};

TEST_F(SurfaceHostile, CutAtAnyByteIsRefusedOrSaid)
{
  const hasp::TriangleMesh truth = Truth();
  for (const Form form :
    { Form::StlText, Form::StlBinary, Form::PlyText, Form::PlyLittle, Form::PlyBig })
  {
    const std::string whole = Bytes(form, truth, "");
    for (std::size_t size = 0; size < whole.size(); ++size)
    {
      const Outcome outcome = this->Try(form, whole.substr(0, size));
      // All is there once endsolid is; what is missing then is the solid's name.
      const bool allThere = form == Form::StlText && whole.find("endsolid") + 8 <= size;
      ASSERT_TRUE(allThere ? outcome == Outcome::Read : outcome != Outcome::Read)
        << int(form) << " cut at " << size << " of " << whole.size();
      if (form == Form::StlBinary || form == Form::PlyLittle || form == Form::PlyBig)
      {
        ASSERT_EQ(outcome, Outcome::Refused) << int(form) << " cut at " << size;
      }
    }
  }
}

TEST_F(SurfaceHostile, CutObjIsSaidWithinALineAndAnywhereIfWeWroteIt)
{
  const std::string foreign = Bytes(Form::Obj, Truth(), "");
  for (std::size_t size = 0; size < foreign.size(); ++size)
    if (this->Try(Form::Obj, foreign.substr(0, size)) == Outcome::Read)
    {
      ASSERT_EQ(foreign[size - 1], '\n') << size; // the limit that LoadSurface names
    }
  hasp::WriteSurface(hasp::MakePolyData(Truth()), (this->Folder / "ours.obj").string());
  const std::string ours = ReadBytes(this->Folder / "ours.obj");
  for (std::size_t size = 0; size < ours.size(); ++size)
    ASSERT_NE(this->Try(Form::Obj, ours.substr(0, size)), Outcome::Read) << size;
}

TEST_F(SurfaceHostile, CutVtpIsRefused)
{
  const std::string whole = Bytes(Form::Vtp, Truth(), "");
  for (std::size_t size = 0; size < whole.size() - 1; size += 41) // each takes a process
    ASSERT_EQ(this->Try(Form::Vtp, whole.substr(0, size)), Outcome::Refused) << size;
}

TEST_F(SurfaceHostile, MutatedStlTextDoesNoHarm)
{
  EXPECT_EQ(this->Mutate(Form::StlText, Files(5000)), 0);
}

TEST_F(SurfaceHostile, MutatedStlBinaryDoesNoHarm)
{
  EXPECT_EQ(this->Mutate(Form::StlBinary, Files(5000)), 0);
}

TEST_F(SurfaceHostile, MutatedPlyTextDoesNoHarm)
{
  EXPECT_EQ(this->Mutate(Form::PlyText, Files(5000)), 0);
}

TEST_F(SurfaceHostile, MutatedPlyLittleEndianDoesNoHarm)
{
  EXPECT_EQ(this->Mutate(Form::PlyLittle, Files(5000)), 0);
}

TEST_F(SurfaceHostile, MutatedPlyBigEndianDoesNoHarm)
{
  EXPECT_EQ(this->Mutate(Form::PlyBig, Files(5000)), 0);
}

TEST_F(SurfaceHostile, MutatedObjDoesNoHarm)
{
  EXPECT_EQ(this->Mutate(Form::Obj, Files(5000)), 0);
}

TEST_F(SurfaceHostile, MutatedVtpDoesNoHarmToUs)
{
  EXPECT_EQ(this->Mutate(Form::Vtp, Files(50)), 0);
}

} // namespace
