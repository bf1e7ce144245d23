#include "Grid/Testing/CountNew.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <new>
#include <thread>

namespace
{

using hasp::test::NewBytes;
using hasp::test::NewCount;
using hasp::test::NewCountOfAllThreads;

constexpr std::align_val_t Wide{ 256 };

struct Form
{
  const char* name;
  std::size_t alignment;
  void* (*take)();
  void (*giveBack)(void*);
};

// A form that is not replaced falls to the standard library's, which does not count all of them, or
// to a sanitizer's, which counts none and refuses what another form gives back.
const Form Forms[] = {
  { "one", 16, [] { return ::operator new(8); }, [](void* m) { ::operator delete(m); } },
  { "array", 16, [] { return ::operator new[](8); }, [](void* m) { ::operator delete[](m); } },
  { "nothrow, given back as std::stable_sort does", 16,
    [] { return ::operator new(8, std::nothrow); }, [](void* m) { ::operator delete(m); } },
  { "nothrow", 16, [] { return ::operator new(8, std::nothrow); },
    [](void* m) { ::operator delete(m, std::nothrow); } },
  { "nothrow array", 16, [] { return ::operator new[](8, std::nothrow); },
    [](void* m) { ::operator delete[](m, std::nothrow); } },
  { "sized", 16, [] { return ::operator new(8); }, [](void* m) { ::operator delete(m, 8); } },
  { "sized array", 16, [] { return ::operator new[](8); },
    [](void* m) { ::operator delete[](m, 8); } },
  { "aligned", 256, [] { return ::operator new(8, Wide); },
    [](void* m) { ::operator delete(m, Wide); } },
  { "aligned array", 256, [] { return ::operator new[](8, Wide); },
    [](void* m) { ::operator delete[](m, Wide); } },
  { "aligned, sized", 256, [] { return ::operator new(8, Wide); },
    [](void* m) { ::operator delete(m, 8, Wide); } },
  { "aligned array, sized", 256, [] { return ::operator new[](8, Wide); },
    [](void* m) { ::operator delete[](m, 8, Wide); } },
  { "aligned, nothrow", 256, [] { return ::operator new(8, Wide, std::nothrow); },
    [](void* m) { ::operator delete(m, Wide, std::nothrow); } },
  { "aligned array, nothrow", 256, [] { return ::operator new[](8, Wide, std::nothrow); },
    [](void* m) { ::operator delete[](m, Wide, std::nothrow); } },
};

TEST(CountNew, EachFormIsCountedOnce)
{
  for (const Form& form : Forms)
  {
    const std::size_t count = NewCount(), bytes = NewBytes(), all = NewCountOfAllThreads();
    void* const memory = form.take();
    const std::size_t taken = NewCount() - count, much = NewBytes() - bytes;
    const std::size_t ofAll = NewCountOfAllThreads() - all;
    const std::uintptr_t odd = reinterpret_cast<std::uintptr_t>(memory) % form.alignment;
    form.giveBack(memory);
    EXPECT_EQ(NewCount() - count, taken) << form.name << ": what is given back is not counted";
    EXPECT_EQ(taken, 1U) << form.name;
    EXPECT_EQ(much, 8U) << form.name;
    EXPECT_EQ(ofAll, 1U) << form.name;
    EXPECT_EQ(odd, 0U) << form.name;
  }
}

TEST(CountNew, WhatAnotherThreadTakesIsNotThisThreads)
{
  std::size_t ofIt = 0, ofAll = 0;
  std::thread other(
    [&]
    {
      const std::size_t first = NewCount(), firstOfAll = NewCountOfAllThreads();
      ::operator delete(::operator new(1));
      ofIt = NewCount() - first;
      ofAll = NewCountOfAllThreads() - firstOfAll;
    });
  const std::size_t before = NewCount();
  other.join();
  EXPECT_EQ(NewCount(), before);
  EXPECT_EQ(ofIt, 1U);
  EXPECT_EQ(ofAll, 1U);
}

TEST(CountNew, OtherThreadsAreRefusedBehindSoMany)
{
  int taken = 0, own = 0;
  const auto take = [](int& count)
  {
    for (int n = 0; n < 5; ++n)
      if (void* const memory = ::operator new(8, std::nothrow))
      {
        ++count;
        ::operator delete(memory);
      }
  };
  {
    const hasp::test::NewRefused refused(3);
    std::thread(take, std::ref(taken)).join();
    take(own);
  }
  EXPECT_EQ(taken, 3);
  EXPECT_EQ(own, 5);
  std::thread(take, std::ref(taken)).join();
  EXPECT_EQ(taken, 8);
}

} // namespace
