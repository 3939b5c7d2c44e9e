// Prefiltered radiance by filtered importance sampling.
// SPDX-License-Identifier: MIT
#include "frame/environment/prefilter.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "math/cube_map.h"
#include "math/sampling.h"

namespace facet::frame {
namespace {

using math::Vec3;

struct Group {
    Lanes x, y;
    Lanes z;
    Lanes weight;
    const CubeMip* mip = nullptr;
};
float P(const char*n, float d){ const char*s=getenv(n); return s?static_cast<float>(atof(s)):d; }

const CubeMip* mip_for(const CubePyramid& pyramid, float sample_sr) {
    const auto face = static_cast<float>(pyramid.mips[0].side) * 2.0F;
    const float texel_sr = 4.0F * math::pi / (6.0F * face * face);
    const float level = 0.5F * std::log2(sample_sr / texel_sr)+P("BIAS",-.5f);
    const float index = std::clamp(std::floor(level + 0.5F), 1.0F, static_cast<float>(pyramid.mips.size()));
    return &pyramid.mips[static_cast<std::size_t>(index) - 1];
}

std::vector<Group> lobe_of(const CubePyramid& pyramid, float roughness) {
    const float alpha = roughness * roughness;
    std::vector<Group> lobe;
    const float q=P("Q",1.6f), r0=P("R0",.5f)*2*alpha; const int m=static_cast<int>(P("M",2));
    float sum=0; float a=0; float b=std::min(r0,1.5f); int ring=0;
    while(a<math::pi/2-1e-4f){
        float w=0,wt=0;
        for(int i=0;i<64;i++){ float th=a+(b-a)*(static_cast<float>(i)+.5f)/64; float c=std::cos(th/2);
          float ww=math::ggx_density(c,alpha)*std::cos(th)*std::sin(th)*(b-a)/64; w+=ww; wt+=ww*th; }
        float th=wt/w; int g=ring==0?1:m; float sr=2*math::pi*(std::cos(a)-std::cos(b))/static_cast<float>(4*g);
        for(int k=0;k<g;k++){ float phi=(static_cast<float>(k)+(ring&1?.5f:0.f))*math::pi/2/static_cast<float>(g); float x=std::sin(th)*std::cos(phi), y=std::sin(th)*std::sin(phi);
          lobe.push_back({Lanes{x,-y,-x,y},Lanes{y,x,-y,-x},lanes_of(std::cos(th)),lanes_of(w/static_cast<float>(4*g)),mip_for(pyramid,sr)}); }
        sum+=w; a=b; b=std::min(b*q,math::pi/2); if(math::pi/2-b<.3f*(b-a)) b=math::pi/2; ring++;
    }
    for(auto&g:lobe) g.weight=g.weight/sum;
    if(getenv("V")) { printf("r %.3f samples %zu rings %d mips:",static_cast<double>(roughness),lobe.size()*4,ring); for(auto&g:lobe) printf(" %u",g.mip->side); puts(""); }
    return lobe;
}

Lanes through_lobe(const std::vector<Group>& lobe, const Vec3& n, const Vec3& t, const Vec3& b) {
    Lanes sum{};
    for (const Group& g : lobe) {
        const FourDirections d{t.x*g.x+b.x*g.y+n.x*g.z,t.y*g.x+b.y*g.y+n.y*g.z,t.z*g.x+b.z*g.y+n.z*g.z};
        sum += g.mip->sum_of(d) * g.weight;
    }
    return sum;
}

}  // namespace

std::vector<std::uint16_t> prefilter(const CubePyramid& pyramid, std::uint32_t side, float roughness,
                                     base::ThreadPool& pool) {
    const std::vector<Group> lobe = lobe_of(pyramid, roughness);
    std::vector<std::uint16_t> out(std::size_t{6} * side * side * 4);
    pool.parallel_for(std::size_t{6} * side, [&](std::size_t row) {
        const auto face = static_cast<std::uint32_t>(row / side);
        const auto place = [&](std::size_t i) {
            return (static_cast<float>(i) + 0.5F) / static_cast<float>(side) * 2.0F - 1.0F;
        };
        // Side faces share one frame around the horizon: the sampling error has no step at their edges.
        const Vec3 up = face == 2 || face == 3 ? Vec3(0.0F, 0.0F, 1.0F) : Vec3(0.0F, 1.0F, 0.0F);
        std::vector<Lanes> texels(side);
        for (std::size_t x = 0; x < side; ++x) {
            const Vec3 n = math::normalize(
                math::direction_from(math::CubePoint{face, place(x), place(row % side)}));
            const Vec3 t = math::normalize(math::cross(up, n));
            texels[x] = through_lobe(lobe, n, t, math::cross(n, t));
        }
        store_halves(texels.data(), side, out.data() + row * side * 4);
    });
    return out;
}

}  // namespace facet::frame
