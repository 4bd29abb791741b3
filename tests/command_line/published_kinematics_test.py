"""`fourpost kinematics` of suspensions whose curves others have published, from their points to their printed digits."""
import csv
import math
import pathlib
import unittest

from program import ProgramTest

PUBLISHED = pathlib.Path(__file__).parent / "published"
HALF_TRACK_MM = 619  # of the Formula Student car's front axle
AXLES = "front=double_wishbone,rear=double_wishbone"


def read(path):
    with open(path) as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def table(name):
    return read(PUBLISHED / f"{name}.csv")


class PublishedKinematics(ProgramTest):
    def drawn(self, points):
        self.write("points.csv", points)
        self.run_program("init", "car", "--suspension", AXLES, "--points", "points.csv")

    def sweep(self, least_mm, most_mm, step_mm, folder):
        """Rows of the left front wheel and of its coil over heave."""
        self.run_program("kinematics", "car/vehicle.urdf", "--travel", f"{least_mm!r}mm:{most_mm!r}mm", "--step",
                         f"{step_mm!r}mm", "-o", folder)
        return [[row for row in read(self.folder / folder / f"{name}.csv")
                 if (row["axle"], row["travel"], row[key]) == ("front", "heave", value)]
                for name, key, value in (("wheels", "wheel", "front_tyre_left"), ("ratios", "strut", "front_coil_left"))]

    def test_has_the_metrics_of_a_formula_student_car(self):
        self.drawn((PUBLISHED / "achilles_points.csv").read_text())

        def change(mm, folder):
            wheels, coils = self.sweep(-mm, mm, mm, folder)
            wheels.sort(key=lambda row: float(row["rise_mm"]))
            coils.sort(key=lambda row: float(row["travel_mm"]))
            found = {name: float(wheels[-1][name]) - float(wheels[0][name])
                     for name in ("camber_deg", "toe_deg", "centre_x_mm", "centre_y_mm")}
            found["length_mm"] = float(coils[-1]["length_mm"]) - float(coils[0]["length_mm"])
            return found
        bump, roll = change(10.0, "bump"), change(HALF_TRACK_MM * math.tan(math.radians(2)), "roll")
        found = {"bump_camber": bump["camber_deg"] / 0.02, "bump_steer": bump["toe_deg"] / 0.02,
                 "recession_long": bump["centre_x_mm"] / 20, "recession_lat": bump["centre_y_mm"] / 20,
                 "spring_ratio": -bump["length_mm"] / 20, "roll_steer": roll["toe_deg"], "roll_camber": roll["camber_deg"]}
        published = table("achilles")
        self.assertEqual({row["quantity"] for row in published}, set(found))
        for row in published:
            self.assertAlmostEqual(found[row["quantity"]], float(row["value"]), delta=float(row["last_digit"]),
                                   msg=row["quantity"])

    def test_has_the_positions_of_a_wheel_that_another_solver_finds(self):
        """The rack's position is that of the points, for the program turns no wheel by its rack."""
        base, steered = table("explorer_points"), {}
        for row in table("explorer_steered"):
            steered.setdefault(row["rack_mm"], {})[row["point"]] = [float(row[axis]) for axis in "xyz"]
        for row in table("explorer"):
            points = "axle,point,x [mm],y [mm],z [mm],on\n"
            for point in base:
                place = [float(point[f"{axis} [mm]"]) for axis in "xyz"]
                if point["point"] in steered[row["rack_mm"]]:
                    place = list(steered[row["rack_mm"]][point["point"]])
                    place[0] -= 2500 if point["axle"] == "rear" else 0
                points += f"{point['axle']},{point['point']},{place[0]!r},{place[1]!r},{place[2]!r},\n"
            self.drawn(points)
            travel = float(row["travel_mm"])
            wheels, _ = self.sweep(min(travel, -4), max(travel, 4), 4.0, f"rack{row['rack_mm']}")
            wheel = min(wheels, key=lambda at: abs(float(at["rise_mm"]) - travel))
            self.assertAlmostEqual(float(wheel["rise_mm"]), travel, delta=1e-9)
            camber, toe = (math.radians(float(wheel[name])) for name in ("camber_deg", "toe_deg"))
            front_view = math.degrees(math.atan(math.tan(camber) / math.cos(toe)))
            # What its residuals of 3e-6 mm are over a kingpin of 300 mm and a steering arm of 100 mm.
            self.assertAlmostEqual(front_view, float(row["camber_deg"]), delta=2e-6)
            self.assertAlmostEqual(float(wheel["toe_deg"]), float(row["toe_deg"]), delta=4e-6)
            for name in ("centre_x_mm", "centre_y_mm"):
                self.assertAlmostEqual(float(wheel[name]), float(row[name]), delta=2e-5)
            self.assertAlmostEqual(float(wheel["track_mm"]) / 2, float(row["half_track_mm"]), delta=2e-5)
            (self.folder / "car").rename(self.folder / f"car{row['rack_mm']}")


if __name__ == "__main__":
    unittest.main()
