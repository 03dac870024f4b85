# Builds LIGGGHTS in its src/ folder, where build.sh has put this file.
# Three things make this quick, and leave out nothing that a script can call:
# - LIGGGHTS's own makefiles also write a dependency file for each source, which
#   doubles the reading of all headers and is of no use in a build from scratch.
# - Reading headers took half of the time: precompiled.h is read once, and
#   OMPI_SKIP_MPICXX leaves out the C++ interface of MPI, which nothing uses.
# - What does no work for each grain in each step is optimized less. That moves
#   no digit: without -ffast-math the level changes the speed only.

# lammps.cpp holds all contact models and takes longest by far: it goes first.
OBJECTS := lammps.o $(filter-out lammps.o, $(patsubst %.cpp, %.o, $(wildcard *.cpp)))
SELDOM := angle% bond% cfd_% change_% citeme% compute_% create_% delete_% dihedral% \
  displace_% dump% finish% image% improper% info% input% kspace% lattice% library% \
  main% min% output% read% replicate% rotate% run% set% special% thermo% universe% \
  variable% velocity% write_%
COMPILE := mpic++ -w -DLAMMPS_GZIP -DLAMMPS_JPEG -DLAMMPS_PNG -DOMPI_SKIP_MPICXX

liggghts: $(OBJECTS)
	@echo "LINK $@"
	@mpic++ $(FLAGS) -o $@ $(OBJECTS) -ljpeg -lpng

# the compiler takes the file of this folder that fits its flags
precompiled.h.gch/often: LEVEL :=
precompiled.h.gch/seldom: LEVEL := -O1
precompiled.h.gch/often precompiled.h.gch/seldom: precompiled.h
	@mkdir -p precompiled.h.gch
	@$(COMPILE) $(FLAGS) $(LEVEL) -x c++-header -c -o $@ $<

$(filter $(SELDOM), $(OBJECTS)): LEVEL := -O1
# a static rule: where a header could only be made by way of a pattern, GNU make
# from 4.4 on would take its own rule for C++
$(OBJECTS): %.o: %.cpp precompiled.h.gch/often precompiled.h.gch/seldom
	@echo "CXX $<"
	@$(COMPILE) $(FLAGS) $(LEVEL) -include precompiled.h -c -o $@ $<

# for build.sh, which turns the CXX lines into a progress report
count:
	@echo $(words $(OBJECTS))
