hasp_add_planner_part(Window
  SOURCES
    Window/KeysPage.cxx Window/KeysPage.h
    Window/LayoutFile.cxx Window/LayoutFile.h
    Window/LayoutNames.cxx Window/LayoutNames.h
    Window/LayoutRects.cxx Window/LayoutRects.h
    Window/LayoutWidgets.cxx Window/LayoutWidgets.h
    Window/MeasureDrag.cxx Window/MeasureDrag.h
    Window/MeasureIsovalue.cxx Window/MeasureIsovalue.h
    Window/MeasureScenes.cxx Window/MeasureScenes.h
    Window/MeasureWindow.cxx Window/MeasureWindow.h
    Window/MessageBar.cxx Window/MessageBar.h
    Window/ObjectActions.cxx
    Window/ObjectList.cxx Window/ObjectList.h
    Window/PanelArea.cxx Window/PanelArea.h
    Window/PlannerFiles.cxx
    Window/PlannerMeasure.cxx Window/PlannerMeasure.h
    Window/PlannerMenus.cxx Window/PlannerMenus.h
    Window/PlannerOptions.cxx Window/PlannerOptions.h
    Window/PlannerScript.cxx Window/PlannerScript.h
    Window/PlannerWindow.cxx Window/PlannerWindow.h
    Window/Recovery.cxx Window/Recovery.h
    Window/RunPlanner.cxx Window/RunPlanner.h
    Window/Samples.cxx Window/Samples.h
    Window/SceneLooks.cxx Window/SceneLooks.h
    Window/StartHint.cxx Window/StartHint.h
    Window/DevicePage.cxx Window/DevicePage.h Window/DevicePageLook.cxx
    Window/StereoPage.cxx Window/StereoPage.h
    Window/StereoSettings.cxx Window/StereoSettings.h
    Window/StereoWindow.cxx Window/StereoWindow.h
    Window/StudyMode.cxx Window/StudyMode.h
    Window/Tour.cxx Window/Tour.h Window/TourStops.cxx
    Window/UsePanel.cxx Window/UsePanel.h
    Window/ViewPresets.cxx Window/ViewPresets.h
    Window/WindowState.cxx Window/WindowState.h
    Window/WorkflowBar.cxx Window/WorkflowBar.h
  LIBRARIES HaspPlannerSteps HaspSceneParts HaspPlanParts Hasp::Studies CLI11::CLI11 X11::X11)

# Its languages, compiled in. lupdate is not run here: Utilities/Docs/Planner.md says when it is.
find_package(Qt5LinguistTools QUIET)
if (NOT Qt5LinguistTools_FOUND)
  message(STATUS "hasp-planner speaks English alone: other languages need lrelease (qttools5-dev)")
else ()
  qt5_add_translation(languages Languages/hasp-planner_sv.ts Languages/qtbase_sv.ts)
  file(CONFIGURE OUTPUT languages.qrc CONTENT [[
<RCC>
  <qresource prefix="/i18n">
    <file>hasp-planner_sv.qm</file>
    <file>qtbase_sv.qm</file>
  </qresource>
</RCC>
]])
  qt5_add_resources(resources "${CMAKE_CURRENT_BINARY_DIR}/languages.qrc")
  # Objects: of a library, the linker would leave out what nothing names.
  add_library(HaspPlannerLanguages OBJECT ${resources})
  target_link_libraries(HaspPlannerLanguages PRIVATE Qt5::Core)
  target_sources(HaspPlannerWindow INTERFACE $<TARGET_OBJECTS:HaspPlannerLanguages>)
endif ()
