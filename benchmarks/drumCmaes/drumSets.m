% DRUMSETS  Runs sets of examples/granudrum, says how far each surface is off.
%
% CALL: octave-cli benchmarks/drumCmaes/drumSets.m WORK SETS OUT
%
% WORK  folder for the case and its runs; what is there is not run again
% SETS  CSV without head: sliding, rolling friction and solid share, a row a set
% OUT   CSV without head: the set, then the root mean square of z at 15 and at
%       45 rpm in mm (NaN: the run failed)
%
% A job of drumCmaes.py. Same model, input and packing (replicate 1) as
% DEcalioc.m in that folder.
%
% See also: compareSurfaces

1;

function result = runSets (root, work)
  here = fullfile (root, 'examples', 'granudrum');
  if ~exist (fullfile (work, 'DEMmodels'), 'dir')
    [~, ~] = mkdir (work);
    system (sprintf ('cp -rL "%s" "%s" "%s" "%s"', ...
                     fullfile (here, 'DEMmodels'), ...
                     fullfile (here, 'loadInput.m'), ...
                     fullfile (here, 'measured.csv'), work));
  end
  given = argv ();
  cd (work);
  startToolbox (root, work);
  useLiggghts (root);
  Case = loadCase (root, work);
  Case.options.maxNewRuns = Inf;
  X = csvread (given{end - 1});
  Z = evaluateDEM (X, Case, 1, 'peer', newProgress ('peer', @disp));
  csvwrite (given{end}, [X, surfaceMiss(Z, [Case.targets.value])], ...
            'precision', '%.10g');
  result.exitStatus = 0;
end

root = fileparts (fileparts (fileparts (mfilename ('fullpath'))));
addpath (fullfile (root, 'infrastructure'), ...
         fullfile (root, 'infrastructure', 'case'), ...
         fullfile (root, 'examples', 'granudrum'));
startMain (@(root, folder) runSets (root, argv (){end - 2}), root);
