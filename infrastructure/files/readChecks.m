% READCHECKS  Reads what a bench says about its own run, and judges it.
%
% CALL: CHECKS = readChecks (FOLDER)
%
% FOLDER  folder of a finished run that holds output_checks.csv
% CHECKS  scalar struct of its numbers (spheresStart, massStart (kg),
%         spheresOut, spheresEnd, settled, overlapMax (of a diameter),
%         timeStep (s), secondsRun (s)) and
%           sane    true if no grain is lost or gained (where spheresSettled is
%                   given: before anything moves), the rest criterion was met
%                   and no overlap exceeded 8 % of a diameter (soft grains deep
%                   in a force chain; the benches stay below 5 % as they stand)
%           reason  why not, '' if sane
%
% Throws DEcalioc:readChecks:missingFile, DEcalioc:readChecks:missingField.
%
% See also: readDump
function checks = readChecks (folder)
  file = fullfile (folder, 'output_checks.csv');
  if exist (file, 'file') ~= 2
    error ('DEcalioc:readChecks:missingFile', ...
           'readChecks: FOLDER must hold output_checks.csv, got %s.', folder);
  end
  words = regexp (fileread (file), '(\w+),(\S+)', 'tokens');
  checks = struct ();
  for k = 1:numel (words)
    checks.(words{k}{1}) = str2double (words{k}{2});
  end
  wanted = {'spheresStart', 'spheresOut', 'spheresEnd', 'settled', ...
            'overlapMax'};
  missing = wanted(~isfield (checks, wanted));
  if ~isempty (missing)
    error ('DEcalioc:readChecks:missingField', ...
           'readChecks: %s must name %s.', file, missing{1});
  end
  checks.reason = judge (checks);
  checks.sane = isempty (checks.reason);
end

function reason = judge (checks)
  balance = checks.spheresStart - checks.spheresOut - checks.spheresEnd;
  if isfield (checks, 'spheresSettled')
    % grains may leave such a bench, but not while they settle
    balance = checks.spheresStart - checks.spheresSettled;
  end
  reason = '';
  if ~(checks.spheresStart > 0)
    reason = 'no grain was inserted';
  elseif ~(balance == 0)
    reason = sprintf ('%g grains are missing', balance);
  elseif ~(checks.settled == 1)
    reason = 'the grains did not come to rest in time: see restTime';
  elseif ~(checks.overlapMax < 0.08)
    reason = sprintf (['overlap of %.3g diameters, 0.08 at most: take ' ...
                       'stiffer grains or slower walls'], checks.overlapMax);
  end
end

%!function folder = sampleRun (ended, overlap)
%!  folder = tempname ();
%!  mkdir (folder);
%!  fid = fopen (fullfile (folder, 'output_checks.csv'), 'w');
%!  fprintf (fid, 'spheresStart,10\nspheresOut,2\nspheresEnd,%d\n', ended);
%!  fprintf (fid, 'settled,1\noverlapMax,%g\n', overlap);
%!  fclose (fid);
%!endfunction

%!test % a sane run, a lost grain, a deep overlap, no number
%! for c = {8, 0.01, true; 7, 0.01, false; 8, 0.09, false; 8, NaN, false}.'
%!   folder = sampleRun (c{1}, c{2});
%!   checks = readChecks (folder);
%!   confirm_recursive_rmdir (false, 'local');
%!   rmdir (folder, 's');
%!   assert (checks.sane, c{3});
%!   assert (isempty (checks.reason), c{3});
%! end

%!test % of a bench that grains may leave: none while they settle
%! folder = sampleRun (5, 0.01);
%! fid = fopen (fullfile (folder, 'output_checks.csv'), 'a');
%! fputs (fid, "spheresSettled,10\n");
%! fclose (fid);
%! assert (readChecks (folder).sane);
%! fid = fopen (fullfile (folder, 'output_checks.csv'), 'a');
%! fputs (fid, "spheresSettled,9\n");
%! fclose (fid);
%! assert (readChecks (folder).reason, '1 grains are missing');
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');

%!error id=DEcalioc:readChecks:missingFile readChecks ('no such folder')
