// gluray objects and gluray pick: the surfaces that a program draws.
#pragma once
#include "command_line.h"
#include "control/one_program.h"

namespace gluray::launcher {

/// The program's objects, as it sends them, in the order of their numbers. Throws.
nlohmann::json objectsOf(HubSession& hub, const RunningProgram& program);

/// The number of an object. Throws where the entry is none.
int64_t objectNumber(const nlohmann::json& object);

/// Prints tables of objects. Returns the exit code.
int listObjects(const CommandLine& line);

/// Prints what is seen at a point of a program's picture. Returns the exit code.
int pickObject(const CommandLine& line);

}  // namespace gluray::launcher
