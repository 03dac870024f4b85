% STARTBENCHMARKS  Puts benchmarks, tests and toolbox on the path.
%
% CALL: ROOT = startBenchmarks ()
%
% ROOT  text, folder of the toolbox
%
% Programs that are functions are called after it:
%   octave-cli --eval "addpath benchmarks; startBenchmarks (); ..."
% The LIGGGHTS of this toolbox comes first in PATH, if it is built.
%
% See also: startToolbox, useLiggghts

function root = startBenchmarks ()
  here = fileparts (mfilename ('fullpath'));
  root = fileparts (here);
  inside = fullfile (here, {'benches', 'figures', 'form', 'leftOut', 'twins', ...
                            fullfile('twins', 'foreign')});
  addpath (fullfile (root, 'infrastructure'), fullfile (root, 'tests'), ...
           fullfile (root, 'tests', 'fuzz'), ...
           fullfile (root, 'tools', 'graph'), ...
           fullfile (root, 'tools', 'pictures'), here, inside{:});
  startToolbox (root);
  useLiggghts (root);
end

%!test
%! root = startBenchmarks ();
%! assert (fileparts (which ('formCase')), ...
%!         fullfile (root, 'benchmarks', 'form'));

% SPDX-License-Identifier: GPL-3.0-only
