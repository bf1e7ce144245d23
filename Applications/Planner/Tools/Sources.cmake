hasp_add_planner_part(Tools
  SOURCES
    Tools/Tool.cxx Tools/Tool.h
    Tools/Planner.cxx Tools/Planner.h
    Tools/AreaTool.cxx Tools/AreaTool.h
    Tools/BladeTool.cxx Tools/BladeTool.h
    Tools/DevicePointer.cxx Tools/DevicePointer.h
    Tools/DistanceBody.cxx Tools/DistanceBody.h
    Tools/DistanceColours.cxx Tools/DistanceColours.h
    Tools/PartOnBone.h
    Tools/FitLook.cxx Tools/FitLook.h
    Tools/FitTool.cxx Tools/FitTool.h
    Tools/HandDevices.cxx Tools/HandDevices.h
    Tools/GrabFollow.cxx Tools/GrabTool.cxx Tools/GrabTool.h
    Tools/LandmarkTool.cxx Tools/LandmarkTool.h
    Tools/MeasureTool.cxx Tools/MeasureTool.h
    Tools/PaintPreview.cxx Tools/PaintPreview.h
    Tools/PaintTool.cxx Tools/PaintTool.h
    Tools/PickTool.cxx Tools/PickTool.h
    Tools/PropCover.cxx Tools/PropCover.h
    Tools/RecordedHand.cxx Tools/RecordedHand.h
    Tools/StrokeEdits.cxx Tools/StrokeEdits.h
    Tools/ToolMarks.cxx Tools/ToolMarks.h
    Tools/Touch.cxx Tools/Touch.h
    Tools/ViewMouse.cxx Tools/ViewMouse.h
    Tools/VtkFaults.cxx Tools/VtkFaults.h
  LIBRARIES HaspPlannerView HaspCommandLineParts Hasp::DeviceDrivers)
