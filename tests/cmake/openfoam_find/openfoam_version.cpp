// Prints the version of libOpenFOAM; fails when headers and library are of different versions.
#include <foamVersion.H>
#include <messageStream.H>

int main() {
  Foam::Info << "libOpenFOAM api " << Foam::foamVersion::api << ", headers " << OPENFOAM
             << Foam::endl;
  return Foam::foamVersion::api == OPENFOAM ? 0 : 1;
}
