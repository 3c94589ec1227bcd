// map_server: a map file as /map. Publishes it latched, serves it as static_map, reads it again on
// ~reload and another one on change_map.
//
//   rosrun wend_ros map_server office.yaml
//   rosrun wend_ros map_server _file:=office.yaml _frame_id:=map

#include <nav_msgs/GetMap.h>
#include <nav_msgs/LoadMap.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <string>

#include "wend/io/map/load_map.hpp"
#include "wend_ros/map_message.hpp"
#include "wend_ros/master_watch.hpp"

namespace {

class MapServer {
 public:
  explicit MapServer(std::string frame_id) : frame_id_(std::move(frame_id)) {}

  /// Loads and publishes a map; what is wrong, empty if nothing is.
  std::string load(const std::string& file) {
    const auto loaded = wend::load_map(file);
    if (!loaded) return loaded.error().message;
    for (const std::string& note : loaded->notes) ROS_WARN_STREAM(file << ": " << note);
    message_ = wend_ros::to_message(loaded->map, frame_id_);
    message_.header.stamp = ros::Time::now();
    message_.info.map_load_time = message_.header.stamp;
    file_ = file;
    publisher_.publish(message_);
    ROS_INFO_STREAM("map " << file << ": " << message_.info.width << " x " << message_.info.height
                           << " cells of " << message_.info.resolution << " m");
    return {};
  }

  void advertise(ros::NodeHandle& node, ros::NodeHandle& own) {
    publisher_ = node.advertise<nav_msgs::OccupancyGrid>("map", 1, true);
    servers_ = {node.advertiseService("static_map", &MapServer::get, this),
                node.advertiseService("change_map", &MapServer::change, this),
                own.advertiseService("reload", &MapServer::reload, this)};
  }

 private:
  bool get(nav_msgs::GetMap::Request&, nav_msgs::GetMap::Response& response) {
    response.map = message_;
    return true;
  }

  bool change(nav_msgs::LoadMap::Request& request, nav_msgs::LoadMap::Response& response) {
    const std::string wrong = load(request.map_url);
    response.map = message_;
    response.result = wrong.empty() ? nav_msgs::LoadMap::Response::RESULT_SUCCESS
                                    : nav_msgs::LoadMap::Response::RESULT_INVALID_MAP_DATA;
    if (!wrong.empty()) ROS_ERROR_STREAM("the map stays as it was: " << wrong);
    return true;
  }

  bool reload(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
    response.message = load(file_);
    response.success = response.message.empty();
    if (!response.success) ROS_ERROR_STREAM("the map stays as it was: " << response.message);
    return true;
  }

  std::string frame_id_;
  std::string file_;
  nav_msgs::OccupancyGrid message_;
  ros::Publisher publisher_;
  std::vector<ros::ServiceServer> servers_;
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "map_server");
  ros::NodeHandle node;
  ros::NodeHandle own("~");
  std::string file = own.param<std::string>("file", argc > 1 ? argv[1] : "");
  if (file.empty() || argc > 2) {
    ROS_ERROR_STREAM("usage: map_server MAP, or the parameter ~file: "
                     << wend::map_formats_text(wend::MapUse::load));
    return 2;
  }
  MapServer server(own.param<std::string>("frame_id", "map"));
  server.advertise(node, own);
  const std::string wrong = server.load(file);
  if (!wrong.empty()) {
    ROS_ERROR_STREAM(wrong);
    return 1;
  }
  const wend_ros::MasterWatch watch;
  ros::spin();
  return 0;
}
