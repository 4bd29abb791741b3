#include "vehicles/description/drawn_vehicle.h"

#include "vehicles/description/design_poses.h"

namespace fourpost {

DrawnVehicle::DrawnVehicle(const Vehicle& described)
    : vehicle(described), values(described.ParameterValues()), poses(DesignPoses(described)) {}

Eigen::Vector3d DrawnVehicle::Place(const Point& point) const { return PlaceOf(point, poses); }

double DrawnVehicle::Length(const ForceLine& line) const { return (Place(line.parent) - Place(line.child)).norm(); }

}  // namespace fourpost
