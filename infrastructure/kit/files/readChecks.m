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
  words = regexp (readText (file), '(\w+),(\S+)', 'tokens');
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
  checks.reason = whyInsane (checks);
  checks.sane = isempty (checks.reason);
end

function reason = whyInsane (checks)
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

%!function checks = checksOf (ended, overlap, more)
%!  folder = emptyFolder ();
%!  writeAtomic (fullfile (folder, 'output_checks.csv'), ...
%!    [sprintf("spheresStart,10\nspheresOut,2\nspheresEnd,%d\n", ended), ...
%!     sprintf("settled,1\noverlapMax,%g\n%s", overlap, more)]);
%!  checks = readChecks (folder);
%!endfunction
%!test
%! % a sane run, a lost grain, a deep overlap, no number; a bench that grains
%! % may leave: none while they settle
%! for c = {8, 0.01, '', ''; 7, 0.01, '', '1 grains are missing'; ...
%!          8, 0.09, '', 'overlap of 0.09'; 8, NaN, '', 'overlap of NaN'; ...
%!          5, 0.01, "spheresSettled,10\n", ''; ...
%!          5, 0.01, "spheresSettled,9\n", '1 grains are missing'}.'
%!   checks = checksOf (c{1:3});
%!   assert (checks.sane, isempty (c{4}));
%!   assert (isempty (strfind (checks.reason, c{4})), isempty (c{4}));
%! end
%!error id=DEcalioc:readChecks:missingFile readChecks ('no such folder')

% SPDX-License-Identifier: GPL-3.0-only
