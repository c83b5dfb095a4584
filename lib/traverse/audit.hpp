// audit.hpp - rays traced again by brute force (traverse/audit.cl), and what differs counted.
#pragma once

#include "device/cl/recorder.hpp"

namespace rsh {

// No ray was audited yet.
void clear_report(Recorder& recorder, cl_mem report);
// Adds to the report.
void audit(Recorder& recorder, const rsh_audit_desc& desc);

}  // namespace rsh
