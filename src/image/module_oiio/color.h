// Displays of OpenColorIO, by way of OpenImageIO.
// SPDX-License-Identifier: MIT
#pragma once

#include "image/module_oiio/interface.h"

/// FacetOiioModule::display.
int facet_oiio_display(const FacetOiioShape* shape, float* pixels, const char* display,
                       const char* view, FacetOiioMessage message);
