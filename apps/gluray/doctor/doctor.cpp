#include "doctor/doctor.h"

#include "doctor/doctor_job.h"
#include "doctor/doctor_machine.h"
#include "doctor/doctor_program.h"
#include "say.h"

#include <iostream>

namespace gluray::launcher {

int doctor(const CommandLine& line) {
  if (!line.job.empty()) return doctorJob(line);
  Diagnosis diagnosis;
  const bool whole = examineInstall(diagnosis);
  examineMachine(diagnosis);
  if (whole) examineDrawing(line, diagnosis);
  if (!line.program.empty()) examineProgram(line, diagnosis);
  std::cout << (line.json ? jsonText(diagnosis.json()) + "\n" : diagnosis.text());
  return diagnosis.exitCode();
}

}  // namespace gluray::launcher
