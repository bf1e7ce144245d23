#include "PlanFixture.h"
#include "Planning/PlanFile.h"
#include "Planning/Sha256.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <thread>
#include <vector>

namespace
{
using namespace hasp;
namespace fs = std::filesystem;

/// The text with its seal made anew: what someone who knows the format could write.
std::string Sealed(std::string text, const std::string& from, const std::string& to)
{
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  const std::string tail = ",\n  \"sha256\": \"";
  text.resize(text.rfind(tail));
  return text + tail + Sha256(text) + "\"\n}\n";
}

std::string Refusal(const std::string& text)
{
  return Thrown([&] { ParsePlan(text); });
}

TEST(Sha256, IsThatOfFips180)
{
  EXPECT_EQ(Sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(Sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(Sha256(std::string(1'000'000, 'a')), // the standard's long message
    "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(PlanFile, ThousandRandomPlansSurviveTheRoundTrip)
{
  for (unsigned seed = 0; seed < 1000; ++seed)
  {
    const PlanDocument document = RandomDocument(seed, int(seed % 12));
    const std::string text = FormatPlan(document);
    const PlanDocument back = ParsePlan(text);
    ASSERT_EQ(back, document) << seed;
    ASSERT_EQ(FormatPlan(back), text) << seed;
    ASSERT_EQ(PlanHash(back.history.Current()), PlanHash(document.history.Current())) << seed;
  }
}

TEST(PlanFile, PlansOnDiskComeBack)
{
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    const PlanFolder folder;
    const PlanDocument document = RandomDocument(seed, 30);
    SavePlan(folder.Plan(), {});
    SavePlan(folder.Plan(), document);
    ASSERT_EQ(LoadPlan(folder.Plan()), document) << seed;
  }
}

TEST(PlanFile, UndoToTheStartAndRedoGiveTheSameHash)
{
  PlanDocument document = RandomDocument(7, 200);
  const std::string start = PlanHash(document.history.Start());
  std::vector<std::string> hashes;
  for (; document.history.ToUndo(); document.history.Undo())
    hashes.push_back(PlanHash(document.history.Current()));
  EXPECT_GT(hashes.size(), 100U);
  EXPECT_EQ(PlanHash(document.history.Current()), start);
  document = ParsePlan(FormatPlan(document)); // saved and loaded in between
  EXPECT_EQ(PlanHash(document.history.Current()), start);
  while (!hashes.empty())
  {
    document.history.Redo();
    ASSERT_EQ(PlanHash(document.history.Current()), hashes.back());
    hashes.pop_back();
  }
}

TEST(PlanFile, TheHashIsThatOfTheText)
{
  const std::string text =
    "{\"caseLabel\":\"K-17\",\"nextId\":1,\"volumes\":[],\"segmentations\":[],"
    "\"surfaces\":[],\"fragments\":[],\"groups\":[],\"cuts\":[],\"guides\":[],\"plates\":[],"
    "\"implants\":[],\"transplants\":[],\"mitreGuides\":[],\"measures\":[],"
    "\"mirrors\":[]}";
  Plan plan;
  plan.caseLabel = "K-17";
  EXPECT_EQ(PlanHash(plan), Sha256(text));
  // Equal plans have equal hashes: 0 and -0 are equal.
  plan = RandomDocument(3, 0).history.Current();
  plan.nextId = 100;
  plan.cuts = { { 90, "", {}, {} } };
  Plan other = plan;
  other.cuts[0].blade.point.x = -0.0;
  ASSERT_EQ(other, plan);
  EXPECT_EQ(PlanHash(other), PlanHash(plan));
  other.cuts[0].blade.point.x = 1e-300;
  EXPECT_NE(PlanHash(other), PlanHash(plan));
}

TEST(PlanFile, EveryFlippedBitIsFound)
{
  const std::string sound = FormatPlan(RandomDocument(11, 3));
  ASSERT_EQ(Refusal(sound), "");
  for (std::size_t at = 0; at < sound.size(); ++at)
    for (unsigned bit = 0; bit < 8; ++bit)
    {
      std::string text = sound;
      text[at] = char(text[at] ^ char(1U << bit));
      ASSERT_EQ(Refusal(text).find("plan.json is damaged"), 0U) << at << ", bit " << bit;
    }
  for (std::size_t size = 0; size < sound.size(); ++size)
    ASSERT_NE(Refusal(sound.substr(0, size)), "") << size;
  EXPECT_NE(Refusal(sound + "\n"), "");
}

TEST(PlanFile, WrongTextsUnderASoundSealAreReadOrRefused)
{
  const std::string sound = FormatPlan(RandomDocument(13, 8)), tail = ",\n  \"sha256\": \"";
  const std::string body = sound.substr(0, sound.rfind(tail));
  std::mt19937 random(2);
  int refused = 0;
  for (int n = 0; n < 1000; ++n)
  {
    std::string text = body;
    const std::size_t at = random() % text.size(), from = random() % text.size();
    const std::size_t size = 1 + random() % 40;
    if (n % 2 == 0)
      text[at] = char(random());
    else
      text.replace(at, size, text.substr(from, size));
    text += tail + Sha256(text) + "\"\n}\n";
    try
    {
      const PlanDocument document = ParsePlan(text);
      ValidatePlan(document.history.Current());
      ASSERT_EQ(ParsePlan(FormatPlan(document)), document); // such as another name
    }
    catch (const std::exception& error)
    {
      ++refused;
      ASSERT_EQ(std::string(error.what()).find("damaged"), std::string::npos) << error.what();
    }
  }
  EXPECT_GT(refused, 800);
}

/// `count` strokes of 60 points, a step each, as painting makes them.
PlanDocument Painted(int count)
{
  PlanDocument document;
  document.history.Do({ AddObject<PlanVolume>{ { 1, "", std::string(64, 'a') } },
    AddObject<PlanSegmentation>{ { 2, "", 1, "", {} } } });
  document.history.Do(AddSegmentationStep{ 2, ThresholdStep{} });
  document.history.Do(AddSegmentationStep{ 2, SplitStep{} });
  std::mt19937 random(6);
  const auto somewhere = [&] { return std::uniform_real_distribution<double>(-200, 200)(random); };
  for (int n = 0; n < count; ++n)
  {
    BrushStroke stroke{ std::uint16_t(2 + n % 4), 2.0, {} };
    while (stroke.points.size() < 60)
      stroke.points.emplace_back(somewhere(), somewhere(), somewhere());
    document.history.Do(AddSegmentationStroke{ 2, std::move(stroke) });
  }
  return document;
}

TEST(PlanFile, AStrokeIsKeptOnceInThePlanAndOnceInItsHistory)
{
  constexpr std::size_t points = 60;
  const std::size_t few = FormatPlan(Painted(50)).size(), many = FormatPlan(Painted(150)).size();
  // A point has three numbers of at most 22 bytes, and its line's spaces; and so much besides.
  const std::size_t most = 2 * (points * (3 * 22 + 30) + 400);
  EXPECT_LT((many - few) / 100, most);
  RecordProperty("bytes of a plan of 100 strokes", int(FormatPlan(Painted(100)).size()));
  const PlanDocument document = Painted(100);
  EXPECT_EQ(ParsePlan(FormatPlan(document)), document);
}

TEST(PlanFile, AFlippedByteOfALargePlanIsFound)
{
  const std::string sound = FormatPlan(RandomDocument(12, 400));
  ASSERT_GT(sound.size(), 300'000U);
  std::mt19937 random(1);
  for (int n = 0; n < 200; ++n)
  {
    std::string text = sound;
    char& byte = text[random() % text.size()];
    byte = char(byte ^ char(1 + random() % 255));
    ASSERT_NE(Refusal(text), "");
  }
}

TEST(PlanFile, AFlippedByteOfABlobIsFoundAndNamed)
{
  const PlanFolder folder;
  const std::string labels = WriteBlob(folder.Plan(), "label map"),
                    part = WriteBlob(folder.Plan(), "");
  PlanDocument document;
  document.history.Do({ AddObject<PlanVolume>{ { 1, "", std::string(64, '0') } },
    AddObject<PlanSegmentation>{ { 2, "", 1, labels } } });
  document.history.Undo(); // what can be redone needs its blobs
  document.parts = { { 1, PartFormat::Stl, {}, part, labels } };
  SavePlan(folder.Plan(), document);
  EXPECT_TRUE(PlanFaults(folder.Plan()).empty());
  const fs::path blob = folder.Plan() / "blobs" / labels;
  const std::string sound = ReadBytes(blob);
  for (std::size_t at = 0; at < sound.size(); ++at)
  {
    std::string bytes = sound;
    bytes[at] = char(bytes[at] ^ 4);
    WriteBytes(blob, bytes);
    const std::vector<std::string> faults = PlanFaults(folder.Plan());
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_EQ(faults[0].find("blobs/" + labels.substr(0, 12) + " is damaged"), 0U) << faults[0];
  }
  EXPECT_NE(Thrown([&] { ReadBlob(folder.Plan(), labels); }), "");
  fs::remove(blob);
  EXPECT_EQ(PlanFaults(folder.Plan()),
    std::vector<std::string>{ "blobs/" + labels.substr(0, 12) + " is not there" });
  WriteBytes(folder.Plan() / "plan.json", "Erika");
  EXPECT_EQ(PlanFaults(folder.Plan()).size(), 1U);
}

TEST(PlanFile, BlobsAreNamedByWhatTheyHold)
{
  const PlanFolder folder;
  std::string bytes(100'000, '\0');
  bytes += "\xff\n";
  const std::string hash = WriteBlob(folder.Plan(), bytes);
  EXPECT_EQ(hash, Sha256(bytes));
  EXPECT_EQ(WriteBlob(folder.Plan(), bytes), hash); // twice is once
  EXPECT_EQ(ReadBlob(folder.Plan(), hash), bytes);
  EXPECT_EQ(Thrown([&] { ReadBlob(folder.Plan(), "../plan.json"); }),
    "blob: name must be 64 hexadecimal digits in lower case, a SHA-256");
}

TEST(PlanFile, ChangesUnderALockAreAllKept)
{
  const PlanFolder folder;
  SavePlan(folder.Plan(), {});
  constexpr int each = 8;
  const auto change = [&]
  {
    for (int n = 0; n < each; ++n)
    {
      const PlanLock lock(folder.Plan());
      PlanDocument document = LoadPlan(folder.Plan());
      const PlanVolume volume{ document.history.NewId(), "", std::string(64, 'a') };
      document.history.Do(AddObject<PlanVolume>{ volume });
      SavePlan(folder.Plan(), document);
    }
  };
  std::vector<std::thread> threads;
  for (int n = 0; n < 4; ++n)
    threads.emplace_back(change);
  for (std::thread& thread : threads)
    thread.join();
  EXPECT_EQ(LoadPlan(folder.Plan()).history.Current().volumes.size(), 4U * each);
  EXPECT_NE(
    Thrown([] { PlanLock("/nowhere/at-all.hasp"); }).find("folder cannot be opened: No such"),
    std::string::npos);
}

TEST(PlanFile, OnlyWhatNothingNamesIsRemoved)
{
  const PlanFolder folder;
  const std::string named = WriteBlob(folder.Plan(), "a"), unused = WriteBlob(folder.Plan(), "b");
  const std::string report = WriteBlob(folder.Plan(), "c");
  PlanDocument document{ {}, { { 1, PartFormat::Obj, {}, named, report } } };
  document.history.Do({ AddObject<PlanVolume>{ { 1, "", std::string(64, '0') } },
    AddObject<PlanSegmentation>{ { 2, "", 1, "", {} } } });
  EXPECT_EQ(BlobsOf(document).size(), 2U); // a segmentation without labels names none
  SavePlan(folder.Plan(), document);
  WriteBytes(folder.Plan() / ".hasp-1-2", "half");
  WriteBytes(folder.Plan() / "blobs" / "notes.txt", "the user's");
  RemoveUnusedBlobs(folder.Plan(), document);
  EXPECT_TRUE(fs::exists(folder.Plan() / "blobs" / named));
  EXPECT_TRUE(fs::exists(folder.Plan() / "blobs" / report));
  EXPECT_FALSE(fs::exists(folder.Plan() / "blobs" / unused));
  EXPECT_FALSE(fs::exists(folder.Plan() / ".hasp-1-2"));
  EXPECT_TRUE(fs::exists(folder.Plan() / "blobs" / "notes.txt"));
  EXPECT_EQ(LoadPlan(folder.Plan()), document);
}

TEST(PlanFile, ErrorsNameTheKeyAndNothingElse)
{
  PlanDocument document;
  document.history.Do({ AddObject<PlanVolume>{ { 1, "Erika", std::string(64, '0') } },
    AddObject<PlanCut>{ { 2, "Erika", {}, {} } } });
  const std::string text = FormatPlan(document);
  EXPECT_EQ(Refusal(Sealed(text, "hasp-plan-5", "hasp-plan-9")),
    "plan: format is none that this version of Hasp reads: hasp-plan-1 to 5");
  EXPECT_EQ(Refusal(Sealed(text, "\"plan\"", "\"plans\"")),
    "plan: a key is unknown, the nearest known is 'plan'; mend its spelling or take it out");
  EXPECT_EQ(Refusal(Sealed(text, "\"name\": \"Erika\"", "\"name\": \"Erik\"")),
    "plan: plan is not the one that its history leads to");
  EXPECT_EQ(Refusal(Sealed(text, "\"kerfMm\": 1.0", "\"kerfMm\": \"1.0\"")),
    "plan: plan.cuts[0].blade.kerfMm must be a number");
  EXPECT_EQ(Refusal(Sealed(text, "\"add\": \"volume\"", "\"add\": \"Erika\"")),
    "plan: history.steps[0].edits[0].add is of no kind that a plan holds");
  EXPECT_EQ(Refusal(Sealed(text, "\"add\": \"volume\"", "\"put\": \"volume\"")),
    "plan: a key of history.steps[0].edits[0] is unknown, the nearest known is 'caseLabel'; mend "
    "its "
    "spelling or take it out");
  EXPECT_EQ(
    Refusal(Sealed(text, "\"done\": 1", "\"done\": 2")), "history: done is 2, must be in [0, 1]");
  EXPECT_EQ(Refusal(Sealed(text, "\"format\"", "Erika")), "plan: no JSON: a mistake at byte 5");
  EXPECT_EQ(Refusal(Sealed(text, "\"nextId\": 3", "\"nextId\": -3")),
    "plan: plan.nextId must be a whole number in [1, 1000000001]");
}

TEST(PlanFile, FoldersThatCannotBeReadOrMadeAreRefused)
{
  const PlanFolder folder;
  EXPECT_EQ(Thrown([&] { LoadPlan(folder.Plan()); }), "plan.json is not there");
  EXPECT_EQ(Thrown([&] { SavePlan(folder.Plan() / "no" / "folder", {}); }),
    "the plan's folder cannot be made: No such file or directory");
  WriteBytes(folder.Plan(), "a file");
  EXPECT_EQ(
    Thrown([&] { SavePlan(folder.Plan(), {}); }), "the plan's folder cannot be made: File exists");
  fs::remove(folder.Plan());
  fs::create_directories(folder.Plan() / "plan.json");
  EXPECT_EQ(Thrown([&] { LoadPlan(folder.Plan()); }), "plan.json is not a file");
}

TEST(PlanFile, NoPathIsInThePlan)
{
  const PlanFolder folder;
  const PlanDocument document = RandomDocument(5, 40);
  WriteBlob(folder.Plan(), "bytes");
  SavePlan(folder.Plan(), document);
  for (const char* name : { "plan.json", "blobs" })
    ASSERT_TRUE(fs::exists(folder.Plan() / name));
  EXPECT_EQ(ReadBytes(folder.Plan() / "plan.json").find("rika"), std::string::npos);
}

} // namespace
