#ifndef WindowContexts_h
#define WindowContexts_h

#include "vtkOpenGLRenderWindow.h"

#include <memory>
#include <vector>

/// What a mapper holds in the OpenGL contexts of windows that drew it, one Context each:
/// Context(window), IsOf(window), IsLost(), Free(window) as in CellContext. Threads: RENDER.
template <typename Context>
class WindowContexts
{
public:
  /// That of the window, whose context is current.
  Context& Of(vtkOpenGLRenderWindow* window)
  {
    this->EraseLost();
    for (const auto& context : this->All)
      if (context->IsOf(window))
        return *context;
    return *this->All.emplace_back(std::make_unique<Context>(window));
  }
  void Free(vtkOpenGLRenderWindow* window)
  {
    for (const auto& context : this->All)
      if (context->IsOf(window))
        context->Free(window);
    this->EraseLost();
  }
  auto begin() const { return this->All.begin(); }
  auto end() const { return this->All.end(); }
  std::size_t size() const { return this->All.size(); }

private:
  void EraseLost()
  {
    std::erase_if(this->All, [](const auto& context) { return context->IsLost(); });
  }

  std::vector<std::unique_ptr<Context>> All;
};

#endif
