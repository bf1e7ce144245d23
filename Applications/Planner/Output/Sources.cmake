hasp_add_planner_part(Output
  SOURCES
    Output/CaseReport.cxx Output/CaseReport.h
    Output/PartExport.cxx Output/PartExport.h
    Output/PartFacts.cxx Output/PartFacts.h
    Output/PartFit.cxx Output/PartFit.h
    Output/PartMaking.cxx Output/PartMaking.h
    Output/PartWork.cxx Output/PartWork.h
    Output/RedParts.cxx Output/RedParts.h
    Output/ReportContents.h
    Output/ReportPage.cxx Output/ReportPage.h
    Output/ReportParts.cxx Output/ReportParts.h
    Output/ReportPdf.cxx
    Output/ReportPictures.cxx Output/ReportPictures.h
    Output/ReportScene.cxx Output/ReportScene.h
    Output/ReportTables.cxx Output/ReportTables.h
    Output/ReportVoxels.cxx Output/ReportVoxels.h
    Output/ScanWorlds.cxx Output/ScanWorlds.h
    Output/StepTimes.cxx Output/StepTimes.h
    Output/StudyFiles.cxx Output/StudyFiles.h
    Output/StudyLog.cxx Output/StudyLog.h
    Output/SusForm.cxx Output/SusForm.h
    Output/SusScore.cxx Output/SusScore.h
  LIBRARIES HaspPlannerTools HaspPlanParts VTK::FiltersCore VTK::FiltersSources)
