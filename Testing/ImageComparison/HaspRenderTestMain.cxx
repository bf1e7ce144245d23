// main() of every render test; HASP_RENDER_TEST is the name of its function.
#include "vtkHaspHeadlessWindows.h"

int HASP_RENDER_TEST(int argc, char* argv[]);

int main(int argc, char* argv[])
{
  hasp::UseHeadlessWindows();
  return HASP_RENDER_TEST(argc, argv);
}
