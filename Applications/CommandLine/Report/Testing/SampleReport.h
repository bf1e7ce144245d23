#pragma once
#include "Report.h"

/// A report that holds, for the tests to break.
inline hasp::Report SampleReport()
{
  hasp::Report report;
  report.name = "cells";
  report.version = "0.1.0";
  report.commit = "abc";
  report.machine = { "Test <CPU>", 2, "AVX2", "" };
  hasp::ReportRow extract;
  extract.id = "cells.extract";
  extract.value = 0.8;
  extract.unit = "ratio";
  extract.better = hasp::Better::Lower;
  extract.rival = "vtkFlyingEdges3D 9.1, normals on";
  extract.error = 0.001;
  extract.errorUnit = "voxel";
  extract.timeS = 0.12;
  extract.q1 = 0.7;
  extract.q3 = 0.9;
  extract.n = 9;
  extract.data = "sphere@64";
  hasp::ReportRow rays;
  rays.id = "cells.rays";
  rays.rival = "Embree 3 triangles";
  rays.absent = "HASP_ENABLE_EMBREE is OFF";
  report.terms = { { "cells.extract", "time from the volume to the cells" },
    { "cells.rays", "rays a second" }, { "cells.error_time", "of a frame" },
    { "distance", "not in this report" } };
  report.rows = { extract, rays };
  report.curves = { { "cells.error_time", "cells", "ms", "voxel", { { 1, 0.1 }, { 10, 0.001 } } },
    { "cells.error_time", "mesh", "ms", "voxel", { { 2, 0.1 } } } };
  report.stability = { { "cells.extreme", "1 x 1 x 2 voxels", true, 0.0, 1e-6, "voxel" } };
  report.unused = { { "second eye", 0, 0.0, "mono" } };
  return report;
}
