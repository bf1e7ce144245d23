hasp_add_planner_part(Views
  SOURCES
    View/FrameView.cxx View/FrameView.h View/FrameViewEvents.cxx
    View/OrientationCube.cxx View/OrientationCube.h
    View/QtRenderWindow.cxx View/QtRenderWindow.h
    View/SceneStyle.cxx View/SceneStyle.h
    View/SceneView.cxx View/SceneView.h
    View/SliceAxis.cxx View/SliceAxis.h
    View/SliceContours.cxx View/SliceContours.h
    View/SliceGrid.cxx View/SliceGrid.h
    View/SliceImage.cxx View/SliceImage.h
    View/SliceIsoline.cxx View/SliceIsoline.h
    View/SliceMarks.cxx View/SliceMarks.h
    View/SliceStyle.cxx View/SliceStyle.h
    View/SliceView.cxx View/SliceView.h View/SliceViewMouse.cxx
    View/ViewGrid.cxx View/ViewGrid.h
    View/ViewMarks.cxx View/ViewMarks.h
  LIBRARIES Hasp::CommonVolume VTK::FiltersCore VTK::GUISupportQt VTK::ImagingCore VTK::InteractionStyle VTK::RenderingImage
    VTK::RenderingOpenGL2)
hasp_add_planner_part(View
  SOURCES
    View/BladeProps.cxx View/BladeProps.h
    View/BlobFile.cxx View/BlobFile.h
    View/BrightestVolume.cxx View/BrightestVolume.h
    View/CellProp.cxx View/CellProp.h
    View/FirstLook.cxx View/FirstLook.h
    View/FragmentLook.cxx View/FragmentLook.h
    View/FragmentProps.cxx View/FragmentProps.h
    View/FragmentWork.cxx View/FragmentWork.h
    View/GhostProps.cxx View/GhostProps.h
    View/MeasureActor.cxx View/MeasureActor.h
    View/MeasureProps.cxx View/MeasureProps.h
    View/MeshProp.cxx View/MeshProp.h
    View/PartProps.cxx View/PartProps.h
    View/PlanScene.cxx View/PlanScene.h
    View/ScanActor.cxx View/ScanActor.h
    View/ScanSurface.cxx View/ScanSurface.h
    View/ScanLooks.cxx View/ScanLooks.h
    View/SceneActor.cxx View/SceneActor.h
    View/SceneCamera.cxx View/SceneCamera.h
    View/SceneEntries.h
    View/SceneJob.cxx View/SceneJob.h
    View/SceneLayer.h
    View/SceneLayers.h
    View/SkinSurface.cxx View/SkinSurface.h
    View/SurfaceProps.cxx View/SurfaceProps.h
    View/ViewLight.cxx View/ViewLight.h
  LIBRARIES HaspPlannerModel HaspPlannerViews HaspSceneParts Hasp::KernelEvaluation Hasp::KernelSegmentation ${needed})
target_link_libraries(HaspPlannerView PRIVATE $<TARGET_NAME_IF_EXISTS:Hasp::RenderingLight>) # HASP_WITH_LIGHT: of HaspSceneParts
