/* Part of DEcalioc, and compiled into LIGGGHTS by tools/liggghts/build.sh.
   GNU General Public License, version 2 or later, as LIGGGHTS itself.

   cohesion dmt: attraction with a pull-off force, after Derjaguin, Muller and
   Toporov 1975. Two bodies that touch attract each other with

     F = 2 pi R* w

   whatever their overlap, so also at overlap zero: that is the force needed to
   part them. R* = ri rj / (ri + rj), between a grain and a wall R* = ri. w is
   the work of adhesion in J/m2, of each pair of atom types:

     fix m all property/global workOfAdhesion peratomtypepair N w11 w12 ...
     pair_style gran model hertz tangential history cohesion dmt ...

   Bodies that do not touch do not attract each other. The limit of friction is
   taken from the repulsion, which the attraction makes larger: mu (F_n + F).
   With tangential_reduce on it is mu |F_n|, F_n the whole normal force. */

#ifdef COHESION_MODEL
COHESION_MODEL(COHESION_DMT,dmt,40)
#else

#ifndef COHESION_MODEL_DMT_H_
#define COHESION_MODEL_DMT_H_

#include "contact_models.h"
#include "cohesion_model_base.h"
#include "global_properties.h"
#include <cmath>

namespace MODEL_PARAMS
{
  inline static MatrixProperty* createWorkOfAdhesion(PropertyRegistry & registry, const char * caller, bool)
  {
    return createPerTypePairProperty(registry, "workOfAdhesion", caller, true, 0.0);
  }
}

namespace LIGGGHTS {
namespace ContactModels {

  template<>
  class CohesionModel<COHESION_DMT> : public CohesionModelBase {
  public:
    CohesionModel(LAMMPS * lmp, IContactHistorySetup * hsetup, class ContactModelBase * c) :
      CohesionModelBase(lmp, hsetup, c),
      work_(NULL),
      reduce_(false)
    {}

    void registerSettings(Settings & settings)
    { settings.registerOnOff("tangential_reduce", reduce_, false); }

    inline void postSettings(IContactHistorySetup *, ContactModelBase *) {}

    void connectToProperties(PropertyRegistry & registry)
    {
      registry.registerProperty("workOfAdhesion", &MODEL_PARAMS::createWorkOfAdhesion);
      registry.connect("workOfAdhesion", work_, "cohesion_model dmt");
      if (force->cg_active())
        error->cg(FLERR, "cohesion model dmt");
    }

    inline void surfacesIntersect(SurfacesIntersectData & sidata, ForceData & i_forces, ForceData & j_forces)
    {
      const double ri = sidata.radi;
      const double reff = sidata.is_wall ? ri : ri * sidata.radj / (ri + sidata.radj);
      const double pull = -2. * M_PI * reff * work_[sidata.itype][sidata.jtype];

      if (reduce_) sidata.Fn += pull;
      if (sidata.contact_flags) *sidata.contact_flags |= CONTACT_COHESION_MODEL;

      // a wall of triangles: each takes its share of the contact
      const double share = sidata.is_wall ? sidata.area_ratio : 1.;
      for (int k = 0; k < 3; k++) {
        const double f = pull * share * sidata.en[k];
        i_forces.delta_F[k] += f;
        if (!sidata.is_wall) j_forces.delta_F[k] -= f;
      }
    }

    void surfacesClose(SurfacesCloseData & scdata, ForceData &, ForceData &)
    {
      if (scdata.contact_flags) *scdata.contact_flags &= ~CONTACT_COHESION_MODEL;
    }

    inline void endSurfacesIntersect(SurfacesIntersectData &, ForceData &, ForceData &) {}
    void beginPass(SurfacesIntersectData &, ForceData &, ForceData &) {}
    void endPass(SurfacesIntersectData &, ForceData &, ForceData &) {}

  private:
    double ** work_;
    bool reduce_;
  };
}
}

#endif
#endif
