#include "wend_ros/reconfigure.hpp"

#include <string>
#include <utility>

#include "wend_ros/option_parameters.hpp"

namespace wend_ros {
Reconfigure::Reconfigure(ros::NodeHandle& own, std::function<void(const Parameters&)> changed)
    : changed_(std::move(changed)) {
  read(own);
  descriptions_ =
      own.advertise<dynamic_reconfigure::ConfigDescription>("parameter_descriptions", 1, true);
  updates_ = own.advertise<dynamic_reconfigure::Config>("parameter_updates", 1, true);
  descriptions_.publish(parameters_.description());
  updates_.publish(parameters_.config());
  changed_(parameters_);
  server_ = own.advertiseService("set_parameters", &Reconfigure::set, this);
}

Parameters Reconfigure::parameters() const {
  const std::lock_guard lock(mutex_);
  return parameters_;
}

void Reconfigure::read(ros::NodeHandle& own) {
  const auto take = [&](const std::string& name) {
    const auto text = parameter_text(own, name);
    if (!text) return;
    const std::string fault = parameters_.set(name, *text);
    if (!fault.empty()) ROS_ERROR_STREAM(fault << "; it stays " << parameters_.text(name));
  };
  for (const wend::OptionInfo& option : parameters_.schema()) {
    if (!option.former.empty()) take(option.former);
    for (const std::string& alias : option.aliases) take(alias);
    take(option.name);
  }
}

bool Reconfigure::set(dynamic_reconfigure::Reconfigure::Request& request,
                      dynamic_reconfigure::Reconfigure::Response& response) {
  Parameters parameters;
  {
    const std::lock_guard lock(mutex_);
    for (const std::string& fault : parameters_.apply(request.config)) ROS_WARN_STREAM(fault);
    parameters = parameters_;
  }
  response.config = parameters.config();
  updates_.publish(response.config);
  changed_(parameters);
  return true;
}

}  // namespace wend_ros
