#include "Window/RunPlanner.h"

int main(int argc, char* argv[])
{
  return hasp::RunPlanner(argc, argv);
}
