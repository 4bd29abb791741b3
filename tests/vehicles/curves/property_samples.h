#pragma once

#include <string>

namespace fourpost {

// Property files as Adams lays them out; all numbers are ours.

/// A coil of 30 N/mm that hardens, 320 mm long without load.
inline const std::string kSpringFile =
    R"($---------------------------------------------------------------------MDI_HEADER
[MDI_HEADER]
 FILE_TYPE     =  'spr'
 FILE_VERSION  =  4.0
 FILE_FORMAT   =  'ASCII'
(COMMENTS)
{comment_string}
'a coil of the tests'
$--------------------------------------------------------------------------UNITS
[UNITS]
 LENGTH  =  'mm'
 ANGLE   =  'degrees'
 FORCE   =  'newton'
 MASS    =  'kg'
 TIME    =  'second'
$--------------------------------------------------------------------SPRING_DATA
[SPRING_DATA]
 FREE_LENGTH  =  320.0   $ without load
$--------------------------------------------------------------------------CURVE
[CURVE]
{     disp        force}
    -50.0      -1500.0
      0.0          0.0
     60.0       1800.0
    120.0       4200.0
)";

/// A tyre of some 200 kN/m that stiffens.
inline const std::string kTyreFile = R"($ A tyre, of which this takes the load-deflection curve.
[MDI_HEADER]
 FILE_TYPE  =  'tir'
 FILE_VERSION  =  3.0
[UNITS]
 LENGTH  =  'meter'
 FORCE  =  'newton'
 ANGLE  =  'radians'
 MASS  =  'kg'
 TIME  =  'second'
[VERTICAL]
 VERTICAL_STIFFNESS  =  2.1e5
[DEFLECTION_LOAD_CURVE]
{pen  fz}
 0.000  0.0
 0.010  1900.0
 0.030  6300.0
)";

/// Rebound pulls with 2400 N at 0.5 m/s, bump pushes with 800 N.
inline const std::string kDamperFile = R"([MDI_HEADER]
 FILE_TYPE     =  'dpr'
 FILE_VERSION  =  4.0
 FILE_FORMAT   =  'ASCII'
[UNITS]
 LENGTH  =  'mm'
 ANGLE   =  'degrees'
 FORCE   =  'newton'
 MASS    =  'kg'
 TIME    =  'second'
[CURVE]
{      vel        force}
   -500.0       -800.0
   -100.0       -300.0
      0.0          0.0
    100.0        700.0
    500.0       2400.0
)";

/// 2 kN/mm, 3 kN/mm and 0.5 kN/mm, free to turn about z.
inline const std::string kBushingFile = R"([MDI_HEADER]
 FILE_TYPE     =  'bus'
 FILE_VERSION  =  4.0
 FILE_FORMAT   =  'ASCII'
[UNITS]
 LENGTH  =  'mm'
 ANGLE   =  'degrees'
 FORCE   =  'newton'
 MASS    =  'kg'
 TIME    =  'second'
[DAMPING]
 FX_DAMPING  =  2.0
 FY_DAMPING  =  3.0
 FZ_DAMPING  =  0.5
 TX_DAMPING  =  10.0
 TY_DAMPING  =  20.0
 TZ_DAMPING  =  0.0
[FX_CURVE]
{  x    fx}
  -2.0  -4000.0
   0.0      0.0
   2.0   4000.0
[FY_CURVE]
{  y    fy}
  -2.0  -6000.0
   2.0   6000.0
[FZ_CURVE]
{  z    fz}
  -2.0  -1000.0
   2.0   1000.0
[TX_CURVE]
{  ax    tx}
 -10.0  -20000.0
  10.0   20000.0
[TY_CURVE]
{  ay    ty}
 -10.0  -40000.0
  10.0   40000.0
[TZ_CURVE]
{  az    tz}
 -10.0  0.0
  10.0  0.0
)";

}  // namespace fourpost
