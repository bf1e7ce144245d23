#include "SurfaceFixture.h"

#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkPolyData.h"

namespace
{

const std::string Hash64 = "0123456789abcdef0123456789abcdef0123456789abcdef0123456789abcdef";

class PartLabels : public SurfaceFixture
{
protected:
  static std::vector<std::string> Endings()
  {
#if HASP_WITH_LIB3MF
    return { ".stl", ".ply", ".obj", ".3mf" };
#else
    return { ".stl", ".ply", ".obj" };
#endif
  }
  std::string File(const std::string& ending) const
  {
    return (this->Folder / ("part" + ending)).string();
  }
  void Write(const std::string& ending, const hasp::PartLabel& label,
    const hasp::InspectPart& inspect = {}) const
  {
    hasp::WriteSurface(hasp::MakePolyData(Truth()), this->File(ending), label, inspect);
  }
  hasp::PartLabel LabelOf(const std::string& ending) const
  {
    return hasp::LoadSurface(this->File(ending)).passport.label;
  }
};

TEST_F(PartLabels, AreReadBackFromEveryFormat)
{
  for (const std::string& ending : Endings())
  {
    SCOPED_TRACE(ending);
    for (const bool red : { false, true })
    {
      const hasp::PartLabel label{ "fragment 3", Hash64, red };
      this->Write(ending, label);
      const auto loaded = hasp::LoadSurface(this->File(ending));
      EXPECT_EQ(loaded.passport.label.doesNotHold, red);
      EXPECT_EQ(loaded.passport.label.hash, ending == ".stl" ? Hash64.substr(0, 16) : Hash64);
      EXPECT_EQ(loaded.passport.label.name, ending == ".stl" && red ? "" : "fragment 3");
      EXPECT_EQ(loaded.passport.warnings.size(), red ? 1U : 0U); // and no more for the label
      EXPECT_EQ(loaded.passport.space, "LPS");
    }
    this->Write(ending, {});
    EXPECT_EQ(this->LabelOf(ending), hasp::PartLabel{});
  }
}

TEST_F(PartLabels, StlHoldsInItsHeadThatAPartDoesNotHoldWhateverElseIsSaid)
{
  for (const char* name : { "", "guide", "part 123456", "reduction" })
  {
    SCOPED_TRACE(name);
    this->Write(".stl", { name, Hash64, true });
    const std::string bytes = ReadBytes(this->File(".stl"));
    ASSERT_EQ(bytes.size(), 284U);
    EXPECT_NE(bytes.substr(0, 80).find("SPACE=LPS; UNIT=mm; DOES NOT HOLD; HASH=0123456789abcdef"),
      std::string::npos);
    EXPECT_EQ(this->LabelOf(".stl").doesNotHold, true);
  }
}

TEST_F(PartLabels, ObjNamesItsObject)
{
  this->Write(".obj", { "plate", "" });
  EXPECT_NE(ReadBytes(this->File(".obj")).find("\no plate\nv "), std::string::npos);
}

TEST_F(PartLabels, NamesAndHashesThatMayNameAPatientAreRefused)
{
  for (const char* name : { "Mustermann", "fragment Mustermann", "Guide", "guide ", " guide",
         "guide 1234567", "guide  1", "mitre guide 1", "fragment 1\n", "fragment -1" })
    EXPECT_FALSE(hasp::IsPartName(name)) << name;
  for (const char* name : { "guide", "fragment 1", "crumb 999999", "segment 0", "mitre-guide 12" })
    EXPECT_TRUE(hasp::IsPartName(name)) << name;
  for (const std::string& ending : Endings())
  {
    for (const hasp::PartLabel& label :
      { hasp::PartLabel{ "Mustermann", "" }, hasp::PartLabel{ "", "0123456789ABCDEF" },
        hasp::PartLabel{ "", "0123" }, hasp::PartLabel{ "", Hash64 + "0" } })
      try
      {
        this->Write(ending, label);
        ADD_FAILURE() << "written: " << ending;
      }
      catch (const std::invalid_argument& error)
      {
        EXPECT_EQ(std::string(error.what()).find("Mustermann"), std::string::npos);
      }
    EXPECT_FALSE(std::filesystem::exists(this->File(ending)));
  }
}

TEST_F(PartLabels, OtherPeoplesTextIsNotTakenForOne)
{
  for (const char* comment : { "Hasp 1 SPACE=LPS; PART=Mustermann; HASH=0123456789abcdef",
         "Hasp 1 SPACE=LPS; PART=guide Erika", "somebody; PART=guide",
         "Hasp 1 SPACE=LPS; HASH=ABCDEF0123456789", "Hasp 1 SPACE=LPS; HASH=01234" })
  {
    SCOPED_TRACE(comment);
    const auto loaded = this->Read(Form::PlyText, Bytes(Form::PlyText, Truth(), comment));
    EXPECT_EQ(loaded.passport.label, hasp::PartLabel{});
  }
}

TEST_F(PartLabels, APartThatDoesNotHoldIsWrittenOnceMoreAndSaysSo)
{
  for (const std::string& ending : Endings())
  {
    SCOPED_TRACE(ending);
    int inspected = 0;
    this->Write(ending, { "guide", Hash64 },
      [&](const std::string& pending)
      {
        ++inspected;
        EXPECT_FALSE(hasp::LoadSurface(pending).passport.label.doesNotHold);
        return hasp::PartVerdict::DoesNotHold;
      });
    EXPECT_EQ(inspected, 1);
    EXPECT_TRUE(this->LabelOf(ending).doesNotHold);
    EXPECT_EQ(hasp::LoadSurface(this->File(ending)).passport.triangles, 4U);
    this->Write(
      ending, { "guide", Hash64 }, [](const std::string&) { return hasp::PartVerdict::Holds; });
    EXPECT_FALSE(this->LabelOf(ending).doesNotHold);
    std::filesystem::remove(this->File(ending));
  }
  EXPECT_TRUE(std::filesystem::is_empty(this->Folder));
}

TEST_F(PartLabels, TheSamePartIsTheSameBytes)
{
  for (const std::string& ending : Endings())
  {
    SCOPED_TRACE(ending);
    this->Write(ending, { "guide", Hash64 });
    const std::string first = ReadBytes(this->File(ending));
    this->Write(ending, { "guide", Hash64 });
    EXPECT_EQ(ReadBytes(this->File(ending)), first);
    this->Write(ending, { "guide", Hash64, true });
    EXPECT_NE(ReadBytes(this->File(ending)), first);
  }
}

} // namespace
