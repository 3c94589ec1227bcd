#pragma once

// What a process uses: memory and time of the processor.

#include <unistd.h>

#include <fstream>
#include <string>

namespace wend_ros {

/// Resident memory, MB.
inline double memory_of(int pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/statm");
  double total = 0;
  double resident = 0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

/// CPU time of all its threads, user and system, s.
inline double cpu_seconds_of(int pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  std::string word;
  while (file >> word && word.back() != ')') {
  }
  // The word behind the name is field 3; 14 and 15 are the times.
  for (int field = 3; field < 14; ++field) file >> word;
  double user = 0;
  double system = 0;
  file >> user >> system;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

}  // namespace wend_ros
