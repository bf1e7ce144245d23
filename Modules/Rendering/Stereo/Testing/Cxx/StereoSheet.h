#pragma once
#include "HaspRenderTest.h"
#include "StereoTestScene.h"

#include <algorithm>

namespace stereotest
{

/// Pictures of one size on one sheet, from the top left on, with a gap between them.
class Sheet
{
public:
  Sheet(int columns, int rows, glm::ivec2 cell) : Columns(columns), Cell(cell)
  {
    this->Whole.width = columns * (cell.x + Gap) + Gap;
    this->Whole.height = rows * (cell.y + Gap) + Gap;
    this->Whole.pixels.assign(std::size_t(3) * this->Whole.width * this->Whole.height, 255);
  }
  /// Into the middle of the next cell; not larger than one.
  void Add(const Bytes& rgb, glm::ivec2 size)
  {
    const int row = this->Next / this->Columns, column = this->Next % this->Columns;
    const glm::ivec2 beside = (this->Cell - size) / 2;
    const int left = Gap + column * (this->Cell.x + Gap) + beside.x;
    const int top = Gap + row * (this->Cell.y + Gap) + beside.y;
    for (int y = 0; y < size.y; ++y)
    {
      const int to = this->Whole.height - top - size.y + y;
      std::copy_n(&rgb[std::size_t(3) * y * size.x], 3 * size.x,
        &this->Whole.pixels[std::size_t(3) * (to * this->Whole.width + left)]);
    }
    ++this->Next;
  }
  const hasp::RGBPicture& Picture() const { return this->Whole; }

private:
  static constexpr int Gap = 6;
  int Columns, Next = 0;
  glm::ivec2 Cell;
  hasp::RGBPicture Whole;
};

} // namespace stereotest
