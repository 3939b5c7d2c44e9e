// Vignetting: what the middle of a lens lets through more of than its edge.

// Natural: the share of the middle's illuminance on the sensor, cos^4 of the angle to the axis (Kingslake 1992,
// "Optics in Photography", p. 121); no telecentric lens, no distortion.
// tangent  [1]  where on the picture, as tangents of the angles to the axis
real natural_vignetting(real2 tangent) {
    return real(1.0) / sqr(real(1.0) + tangent.x * tangent.x + tangent.y * tangent.y);
}
// Mechanical: 1 where a ray passes the round rim of the barrel before the lens, else 0. From aside the rim lies over
// the aperture like one coin over another, less so the smaller the aperture is.
// lens   [m]       place on the lens that the ray comes through
// rim    [m]       radius of the rim
// shift  [m]       by how much the rim has moved where the tangent is 1
real mechanical_vignetting(real2 tangent, real2 lens, real rim, real shift) {
    real x = lens.x + tangent.x * shift;
    real y = lens.y + tangent.y * shift;
    return x * x + y * y <= rim * rim ? real(1.0) : real(0.0);
}
