# Builds LIGGGHTS in its src/ folder, where build.sh has put this file.
# LIGGGHTS's own makefiles also write a dependency file for each source, which
# doubles the reading of all headers and is of no use in a build from scratch.

# lammps.cpp holds all contact models and takes longest by far: it goes first.
OBJECTS := lammps.o $(filter-out lammps.o, $(patsubst %.cpp, %.o, $(wildcard *.cpp)))

liggghts: $(OBJECTS)
	@echo "LINK $@"
	@mpic++ $(FLAGS) -o $@ $(OBJECTS) -ljpeg -lpng

%.o: %.cpp
	@echo "CXX $<"
	@mpic++ $(FLAGS) -w -DLAMMPS_GZIP -DLAMMPS_JPEG -DLAMMPS_PNG -c -o $@ $<

# for build.sh, which turns the CXX lines into a progress report
count:
	@echo $(words $(OBJECTS))
