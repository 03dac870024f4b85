% The example of another DEM code, LAMMPS: calibrated to its end where lmp is
% installed, and its form looked at everywhere.

%!function folder = copyOf (root)
%!  folder = tempname ();
%!  mkdir (folder);
%!  copyfile (fullfile (root, 'examples', 'lammps', '*'), folder);
%!  confirm_recursive_rmdir (false, 'local');
%!  for name = {'optim', 'results', 'KrigingFuns'}
%!    [~, ~] = rmdir (fullfile (folder, name{1}), 's');
%!  end
%!endfunction

%!test % a program of that name is all that may be missing
%! root = fileparts (fileparts (which ('startProgram')));
%! folder = copyOf (root);
%! [status, out] = startCommand (folder, 'check');
%! if isempty (file_in_path (getenv ('PATH'), 'lmp'))
%!   assert (status == 1 && ~isempty (strfind (out, '1 problem')), out);
%!   assert (~isempty (strfind (out, 'a program lmp')), out);
%! else
%!   assert (status == 0 && isempty (strfind (out, 'WARNING')), out);
%! end
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'lmp'))
%! % the known answer lies in the intervals, and the values go back to LAMMPS
%! root = fileparts (fileparts (which ('startProgram')));
%! folder = copyOf (root);
%! [status, out] = startCommand (folder, 'run');
%! assert (status == 0, out);
%! c = jsondecode (fileread (fullfile (folder, 'results', 'calibration.json')));
%! truth = struct ('name', {'coefFrictionPP', 'coefRollingFrictionPP'}, ...
%!                 'value', {0.45, 0.15});
%! for t = truth
%!   range = c.interval90.(t.name);
%!   assert (range(1) <= t.value && t.value <= range(2), out);
%! end
%! [status, out] = startCommand (folder, 'export --for lammps');
%! assert (status == 0 && ~isempty (strfind (out, 'pair_style granular')), out);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');

% SPDX-License-Identifier: GPL-3.0-only
