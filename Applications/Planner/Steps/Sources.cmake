hasp_add_planner_part(Steps
  SOURCES
    Steps/StepPanel.h
    Steps/CertificateBox.cxx Steps/CertificateBox.h
    Steps/CertificateDialog.cxx Steps/CertificateDialog.h
    Steps/CheckPanel.cxx Steps/CheckPanel.h
    Steps/ExportPanel.cxx Steps/ExportPanel.h
    Steps/FitBox.cxx Steps/FitBox.h
    Steps/PartTable.cxx Steps/PartTable.h
    Steps/PlanFigures.cxx Steps/PlanFigures.h
    Steps/BonesBox.cxx Steps/BonesBox.h
    Steps/FileQuestion.cxx Steps/FileQuestion.h
    Steps/FragmentMaking.cxx Steps/FragmentMaking.h
    Steps/FragmentTable.cxx Steps/FragmentTable.h
    Steps/ImportEdits.cxx Steps/ImportEdits.h
    Steps/ImportPanel.cxx Steps/ImportPanel.h
    Steps/ImportReading.cxx Steps/ImportReading.h
    Steps/ImportRemedies.cxx Steps/ImportRemedies.h
    Steps/IsovalueBox.cxx Steps/IsovalueBox.h
    Steps/LabelFindings.cxx Steps/LabelFindings.h
    Steps/LabelList.cxx Steps/LabelList.h
    Steps/LabelMaps.cxx Steps/LabelMaps.h
    Steps/MissingInputs.cxx Steps/MissingInputs.h
    Steps/MoveEdits.cxx Steps/MoveEdits.h
    Steps/NudgePad.cxx Steps/NudgePad.h
    Steps/PanelWidgets.cxx Steps/PanelWidgets.h
    Steps/PassportBrowser.cxx Steps/PassportBrowser.h
    Steps/PassportPage.cxx Steps/PassportPage.h
    Steps/ReducePanel.cxx Steps/ReducePanel.h
    Steps/ReductionProposals.cxx Steps/ReductionProposals.h
    Steps/ReductionWork.cxx Steps/ReductionWork.h
    Steps/SplitPanel.cxx Steps/SplitPanel.h
    Steps/SurfaceShelf.cxx Steps/SurfaceShelf.h
    Steps/WrappedRows.cxx Steps/WrappedRows.h
    Steps/BladeNudge.cxx Steps/BladeNudge.h
    Steps/CutPanel.cxx Steps/CutPanel.h Steps/CutRows.cxx
    Steps/FaultLine.cxx Steps/FaultLine.h
    Steps/GuideBox.cxx Steps/GuideBox.h Steps/GuidePins.cxx Steps/GuideRows.cxx
    Steps/GuidePanel.cxx Steps/GuidePanel.h
    Steps/ImplantBox.cxx Steps/ImplantBox.h
    Steps/MatchPoints.h
    Steps/MitreBox.cxx Steps/MitreBox.h
    Steps/NumberText.cxx Steps/NumberText.h
    Steps/ObjectBox.h
    Steps/ObjectChecks.cxx Steps/ObjectChecks.h
    Steps/ObjectChooser.cxx Steps/ObjectChooser.h
    Steps/ObjectDraft.h
    Steps/PaintedArea.cxx Steps/PaintedArea.h
    Steps/PanelGroup.h
    Steps/PartStatus.cxx Steps/PartStatus.h
    Steps/PiecesBox.cxx Steps/PiecesBox.h
    Steps/PlateBox.cxx Steps/PlateBox.h
    Steps/PlatePanel.cxx Steps/PlatePanel.h
    Steps/PointsEdit.cxx Steps/PointsEdit.h
    Steps/RecipeForm.cxx Steps/RecipeForm.h Steps/RecipeFormRows.cxx
    Steps/TouchButton.cxx Steps/TouchButton.h
    Steps/TouchedFragment.cxx Steps/TouchedFragment.h
    Steps/TransplantBox.cxx Steps/TransplantBox.h Steps/TransplantDonor.cxx Steps/TransplantRows.cxx
  LIBRARIES HaspPlannerOutput)
