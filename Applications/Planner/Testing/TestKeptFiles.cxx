#include "Model/KeptFiles.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>

#include <chrono>
#include <fstream>
#include <set>
#include <string>

using namespace hasp;

namespace
{
namespace fs = std::filesystem;

class KeptFiles : public testing::Test
{
protected:
  /// So many bytes that are so many hours old.
  void Put(const std::string& name, std::size_t bytes, int hours)
  {
    const fs::path file = this->Place() / name;
    std::ofstream(file) << std::string(bytes, 'x');
    fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(hours));
  }
  std::set<std::string> Names() const
  {
    std::set<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(this->Place()))
      names.insert(entry.path().filename().string());
    return names;
  }
  fs::path Place() const { return this->Folder.path().toStdString(); }

  QTemporaryDir Folder;
};

using Set = std::set<std::string>;

TEST_F(KeptFiles, TheOldestGoUntilTheRestFits)
{
  this->Put("a.ply", 100, 3);
  this->Put("b.ply", 100, 1);
  this->Put("c.ply", 100, 2);
  DropOldestFiles(this->Place(), 300);
  EXPECT_EQ(this->Names(), (Set{ "a.ply", "b.ply", "c.ply" }));
  DropOldestFiles(this->Place(), 299);
  EXPECT_EQ(this->Names(), (Set{ "b.ply", "c.ply" }));
  DropOldestFiles(this->Place(), 100);
  EXPECT_EQ(this->Names(), (Set{ "b.ply" }));
}

TEST_F(KeptFiles, FilesOfOneNameGoTogetherAndAreAsOldAsTheNewest)
{
  this->Put("a.nrrd", 100, 1);
  this->Put("a.json", 10, 9); // older than anything
  this->Put("b.nrrd", 100, 5);
  this->Put("b.json", 10, 5);
  DropOldestFiles(this->Place(), 200);
  EXPECT_EQ(this->Names(), (Set{ "a.nrrd", "a.json" }));
}

TEST_F(KeptFiles, TheNewestStaysHoweverLargeItIs)
{
  this->Put("a.ply", 1000, 1);
  this->Put("b.ply", 1, 2);
  DropOldestFiles(this->Place(), 10);
  EXPECT_EQ(this->Names(), (Set{ "a.ply" }));
  DropOldestFiles(this->Place() / "none", 10); // no folder is no error
}

} // namespace
