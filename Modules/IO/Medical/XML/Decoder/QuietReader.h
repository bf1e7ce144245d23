#pragma once
#include "XMLOutput.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataArraySelection.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <istream>

/// One of VTK's XML readers, from a file that is open already, its errors caught instead of
/// printed: their texts may quote the file.
template <typename Reader>
class QuietReader : public Reader
{
public:
  static QuietReader* New() { VTK_STANDARD_NEW_BODY(QuietReader); }

  void SetFile(BeatingFile* file)
  {
    this->Input.rdbuf(file);
    this->SetFileName("-"); // VTK wants a name; it is never opened
    vtkNew<vtkCallbackCommand> note;
    note->SetClientData(&this->Failed);
    note->SetCallback(
      [](vtkObject*, unsigned long, void* failed, void*) { *static_cast<bool*>(failed) = true; });
    this->AddObserver(vtkCommand::ErrorEvent, note);
    this->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, note);
    // The XML parser inside tells its errors here.
    this->SetParserErrorObserver(note);
    this->SetReaderErrorObserver(note);
  }
  bool HasFailed() { return this->Failed || this->GetErrorCode() != 0; }

protected:
  int OpenStream() override
  {
    this->Input.clear();
    this->Input.seekg(0);
    this->Stream = &this->Input;
    return this->Input.good() ? 1 : 0;
  }
  void CloseStream() override { this->Stream = nullptr; }

private:
  std::istream Input{ nullptr };
  bool Failed = false;
};
