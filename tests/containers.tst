% The container models Lift100 and SmallBin: their meshes are what their
% scripts write, getResults reads a finished run and refuses a broken one, and
% (where LIGGGHTS is on the PATH) SmallBin runs, repeats itself and is sound.

%!function folder = modelFolder (model)
%!  here = fileparts (which ('startToolbox'));
%!  folder = fullfile (fileparts (here), 'DEMmodels', model);
%!endfunction

%!function res = resultsOf (model, change)
%!  % results of the model's sample, changed by: change (folder of the run)
%!  global path
%!  base = tempname ();
%!  run = fullfile (base, 'optim', model, '0001');
%!  mkdir (run);
%!  confirm_recursive_rmdir (false, 'local');
%!  copyfile (fullfile (modelFolder (model), 'sample', '*'), run);
%!  change (run);
%!  funs = fullfile (modelFolder (model), 'OctaveFuns');
%!  before = path;
%!  path = [base, '/'];
%!  addpath (funs);
%!  res = getResults (model, '0001');
%!  rmpath (funs);
%!  path = before;
%!  clear -global path
%!  rmdir (base, 's');
%!endfunction

%!function run = runSmallBin (line)
%!  % a finished run in a new folder; line: added to data.head
%!  run = tempname ();
%!  copyfile (modelFolder ('SmallBin'), run);
%!  fid = fopen (fullfile (run, 'data.head'), 'a');
%!  fprintf (fid, '%s\n', line);
%!  fclose (fid);
%!  status = system (['cd ''', run, ''' && bash ./runscript > out 2> err']);
%!  assert (status, 0);
%!  assert (regexp (fileread (fullfile (run, 'out')), ...
%!                  'RUN COMPLETE\s*$') > 0);
%!endfunction

%!function checks = checksOf (run)
%!  text = fileread (fullfile (run, 'output_checks.csv'));
%!  found = regexp (text, '^(\w+),(\S+)$', 'tokens', 'lineanchors');
%!  found = vertcat (found{:});
%!  checks = cell2struct (num2cell (str2double (found(:, 2))), found(:, 1), 1);
%!endfunction

% --- the meshes are reproduced to the last byte
%!test
%! makers = {'Lift100', 'makeContainer', 'container.stl'; ...
%!           'SmallBin', 'makeBin', 'bin.stl'};
%! for k = 1:rows (makers)
%!   meshes = fullfile (modelFolder (makers{k, 1}), 'meshes');
%!   file = tempname ();
%!   addpath (meshes);
%!   feval (makers{k, 2}, file);
%!   rmpath (meshes);
%!   made = fileread (file);
%!   delete (file);
%!   assert (made, fileread (fullfile (meshes, makers{k, 3})));
%! end

% --- the container holds what the density is divided by: pi/4 0.1^2 0.06 m3
%!test
%! text = fileread (fullfile (modelFolder ('Lift100'), 'meshes', ...
%!                            'container.stl'));
%! found = regexp (text, 'vertex (\S+) (\S+) (\S+)', 'tokens');
%! x = str2double (vertcat (found{:}));
%! assert (rows (x), 3 * 288);
%! assert ([min(x(:, 3)), max(x(:, 3))], [0, 0.06], 1e-9);
%! r = unique (round (1e7 * hypot (x(:, 1), x(:, 2)))) / 1e7;
%! assert (numel (r), 2);
%! assert (36 * r(2) ^ 2 * sin (2 * pi / 72), pi * 0.05 ^ 2, 1e-7);
%! assert (36 * r(1) ^ 2 * sin (2 * pi / 72), pi * 0.0165 ^ 2, 1e-7);

% --- a finished run
%!test
%! for model = {'Lift100', 'SmallBin'}
%!   sample = fullfile (modelFolder (model{1}), 'sample');
%!   wanted = {str2double(fileread (fullfile (sample, 'output_density'))), ...
%!             str2double(fileread (fullfile (sample, 'output_mass')))};
%!   assert (resultsOf (model{1}, @(run) []), wanted);
%!   assert (all (isfinite ([wanted{:}])));
%! end

% --- broken runs: each result is lost alone
%!test
%! for model = {'Lift100', 'SmallBin'}
%!   res = resultsOf (model{1}, @(run) delete (fullfile (run, 'output_mass')));
%!   assert (isnan ([res{:}]), [false, true]);
%!   res = resultsOf (model{1}, ...
%!                    @(run) delete (fullfile (run, 'output_density')));
%!   assert (isnan ([res{:}]), [true, false]);
%!   res = resultsOf (model{1}, ...
%!                    @(run) delete (fullfile (run, 'output_checks.csv')));
%!   assert (isnan ([res{:}]), [true, true]);
%!   res = resultsOf (model{1}, @(run) delete (fullfile (run, '*')));
%!   assert (isnan ([res{:}]), [true, true]);
%! end

% --- a sphere is lost, or the filling does not reach the filling height
%!function changeCount (run, name, factor, offset)
%!  file = fullfile (run, 'output_checks.csv');
%!  text = fileread (file);
%!  old = regexp (text, ['^', name, ',(\S+)$'], 'tokens', 'once', ...
%!                'lineanchors'){1};
%!  new = sprintf ('%d', round (factor * str2double (old)) + offset);
%!  fid = fopen (file, 'w');
%!  fputs (fid, strrep (text, [name, ',', old], [name, ',', new]));
%!  fclose (fid);
%!endfunction
%!test
%! for model = {'Lift100', 'SmallBin'}
%!   res = resultsOf (model{1}, ...
%!                    @(run) changeCount (run, 'spheresEnd', 1, -1));
%!   assert (isnan ([res{:}]), [false, true]);
%!   res = resultsOf (model{1}, ...
%!                    @(run) changeCount (run, 'spheresFilled', 0.5, 0));
%!   assert (isnan ([res{:}]), [true, false]);
%! end

% --- a real run: same seed, same digits; another seed, another packing
%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'liggghts'))
%! confirm_recursive_rmdir (false, 'local');
%! lines = {'variable runSeed equal 10037', 'variable runSeed equal 10037', ...
%!          'variable runSeed equal 10039'};
%! runs = cellfun (@runSmallBin, lines, 'UniformOutput', false);
%! read = @(run) fileread (fullfile (run, 'discharge_curve.csv'));
%! assert (read (runs{1}), read (runs{2}));
%! assert (~ strcmp (read (runs{1}), read (runs{3})));
%! for k = 1:3
%!   c = checksOf (runs{k});
%!   assert (c.spheresKept, c.spheresOut + c.spheresEnd);
%!   assert (c.overlapMax < 0.05);
%!   assert (c.settleByRest, 1);
%!   assert (c.rayleighShare, 0.4, 1e-6);
%!   rmdir (runs{k}, 's');
%! end

% --- SIMTS is the time step of a run
%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'liggghts'))
%! confirm_recursive_rmdir (false, 'local');
%! run = runSmallBin (['variable SIMTS equal 9e-5', "\n", ...
%!                     'variable dischargeTime equal 0.1']);
%! assert (checksOf (run).timeStep, 9e-5, 1e-12);
%! rmdir (run, 's');

% SPDX-License-Identifier: GPL-3.0-only
