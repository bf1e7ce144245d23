hasp_add_planner_part(Model
  SOURCES
    Model/ErrorText.h Model/JobQueue.cxx Model/JobQueue.h
    Model/KeptFiles.cxx Model/KeptFiles.h
    Model/ObjectNames.cxx Model/ObjectNames.h
    Model/PlanSession.cxx Model/PlanSession.h Model/PlanSessionSaving.cxx
    Model/ScanShelf.cxx Model/ScanShelf.h
    Model/WorkFolder.cxx Model/WorkFolder.h
    Model/RecentPlans.cxx Model/RecentPlans.h
  LIBRARIES Hasp::KernelPlanning Hasp::KernelRealtime Hasp::IOMedical Hasp::CommonVolume nlohmann_json::nlohmann_json)
