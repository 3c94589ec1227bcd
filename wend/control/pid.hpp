#pragma once

// PidTerm: one feedback loop of a PID controller, with a filtered derivative and anti-windup.
//
//   wend::PidTerm heading({.proportional = 3, .integral = 0.2, .derivative = 0.1}, 0.1);
//   const double turn_rate = heading.output(error, change, 0.05, 1.5);
//
// is proportional times the error, plus integral times its sum over time, plus derivative times its
// filtered slope. The derivative goes through a first-order filter. Anti-windup is conditional integration: while u
// is beyond its limit, an error that would drive it farther is not summed.

namespace wend {

struct PidGains {
  double proportional = 1;
  double integral = 0;
  double derivative = 0;
};

class PidTerm {
 public:
  PidTerm(const PidGains& gains, double filter_time) : gains_(gains), filter_time_(filter_time) {}

  void reset();

  /// `change` is what the error changed by since the last time, where that is not the plain
  /// difference (of angles); the first time it does not count.
  double output(double error, double change, double seconds, double limit);

  double integral() const { return integral_; }

 private:
  PidGains gains_;
  double filter_time_;  // s
  double integral_ = 0;
  double slope_ = 0;  // filtered
  bool is_first_ = true;
};

}  // namespace wend
