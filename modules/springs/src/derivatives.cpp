#include <tencer/springs/derivatives.hpp>
#include <tencer/springs/law.hpp>

namespace tencer::springs {
namespace {

bool pulls_or_pushes(const Cable& cable, double length) {
  return length > 0 && !(cable.tension_only && length < cable.rest_length);
}

}  // namespace

Eigen::Vector3d force_by_stiffness(const Cable& cable, const Eigen::Vector3d& d) {
  const double length = d.norm();
  if (!pulls_or_pushes(cable, length)) return Eigen::Vector3d::Zero();
  return (length - cable.rest_length) / length * d;
}

Eigen::Vector3d force_by_rest_length(const Cable& cable, const Eigen::Vector3d& d) {
  const double length = d.norm();
  if (!pulls_or_pushes(cable, length)) return Eigen::Vector3d::Zero();
  return -cable.stiffness / length * d;
}

std::array<double, 4> weight_rates(const Cable& cable, const Stencil& stencil,
                                   std::span<const geometry::ArcLength> rods,
                                   Attachment attachment) {
  std::array<double, 4> rates{};
  const auto* on_rod = std::get_if<OnRod>(attachment == Attachment::a ? &cable.a : &cable.b);
  if (!on_rod) return rates;
  // The shares of end a come first, and of each end's two the first is the edge's first vertex.
  const bool second_pair = attachment == Attachment::b && stencil.count == 4;
  const int first = second_pair ? 2 : 0;
  const double sign = attachment == Attachment::a ? -1.0 : 1.0;
  const double rate = sign / rods[on_rod->rod].edge_length(stencil.shares[first].vertex);
  rates[first] = -rate;
  rates[first + 1] = rate;
  return rates;
}

Response respond(const Cable& cable, const Eigen::Vector3d& d, const Variation& v) {
  Response response;
  const double r = d.norm();
  const double k = cable.stiffness;
  if (r == 0 && cable.rest_length == 0) {
    // The force is k d, without a direction that d would have to give.
    response.force_1 = k * v.span_1;
    response.force_2 = k * v.span_2;
    response.force_12 = k * v.span_12 + v.stiffness_2 * v.span_1;
    response.by_stiffness_12 = v.span_1.dot(v.span_2);
    return response;
  }
  if (!pulls_or_pushes(cable, r)) return response;
  const double stretch = r - cable.rest_length;
  const double r1 = d.dot(v.span_1) / r;
  const double r2 = d.dot(v.span_2) / r;
  const double r12 = (d.dot(v.span_12) + v.span_1.dot(v.span_2) - r1 * r2) / r;
  const double stretch2 = r2 - v.rest_length_2;
  const double tension1 = k * r1;
  const double tension2 = k * stretch2 + v.stiffness_2 * stretch;
  const double tension12 = k * r12 + v.stiffness_2 * r1;
  // The force is density * d with density = tension / r.
  const double density = k * stretch / r;
  const double density1 = (tension1 - density * r1) / r;
  const double density2 = (tension2 - density * r2) / r;
  const double density12 = (tension12 - density1 * r2 - density2 * r1 - density * r12) / r;
  response.force_1 = density1 * d + density * v.span_1;
  response.force_2 = density2 * d + density * v.span_2;
  response.force_12 =
      density12 * d + density1 * v.span_2 + density2 * v.span_1 + density * v.span_12;
  response.by_stiffness_12 = r1 * stretch2 + stretch * r12;
  response.by_rest_length_12 = -tension12;
  return response;
}

}  // namespace tencer::springs
