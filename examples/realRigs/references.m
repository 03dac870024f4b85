% REFERENCES  How well the benches reproduce the references of the real rigs.
%
% CALL: octave-cli examples/realRigs/references.m
%
% Prints the table references.csv from gap/gap.json of every case that is diagnosed:
% rig, model, reading, measured (at the reference), calibrated (what the calibrated model
% gives there), allowed, used (1, or 0: the model cannot follow the reading, see setAside;
% a single one is used in any case), and in a last line of each rig how many are within
% what is allowed.
%
% See also: diagnoseGap, setAside

1;

function sayRig (name, file)
  gap = jsondecode (fileread (file));
  list = jsonList (gap, {'reference', 'targets'});
  for k = 1:numel (list)
    T = list{k};
    printf ("%s,%s,%s,%.4g,%.4g,%.2g,%d\n", name, T.model, T.name, T.reference, ...
            T.simulated, T.allowed, T.followed);
  end
  isMet = cellfun (@(T) abs (T.simulated - T.reference) <= T.allowed, list);
  printf ("%s,,within what is allowed,,%d of %d,,\n", name, sum (isMet), numel (list));
end

root = fullfile (fileparts (mfilename ('fullpath')), '..', '..');
addpath (fullfile (root, 'infrastructure'));
startToolbox (make_absolute_filename (root));
printf ("rig,model,reading,measured,calibrated,allowed,used\n");
here = fileparts (mfilename ('fullpath'));
for rig = {'doser/P', 'doser/Q', 'doser/R', 'liquid_columns', 'ring_shear', ...
           'doser_shots/A', 'doser_shots/B', 'doser_shots/C', 'liquid_columns2', ...
           'heaps/A', 'heaps/B', 'heaps/C', 'ring_tester'}
  file = fullfile (here, rig{1}, 'gap', 'gap.json');
  if isfile (file)
    sayRig (rig{1}, file);
  end
end

% SPDX-License-Identifier: GPL-3.0-only
