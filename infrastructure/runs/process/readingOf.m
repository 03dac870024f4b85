% READINGOF  A record of a run as it answers the question of a case.
%
% CALL: RECORD = readingOf (RECORD, H)
%
%   RECORD  see newRecord; with the field readings, 1 x n struct array with
%           funs, status, message, cause and results (1 x m): what the run has
%           answered to other questions
%   H       element of hashModels: funs is the digest of OctaveFuns and of the
%           places measured, count how many results are asked for
%
% A simulation that ended well may be asked by several cases: by materials that
% were measured at other places, or before and after a change of getResults. One
% that has not been asked this yet has the status 'ended' and no results: it is
% to be read (collectRuns), not to be run again.
%
% See also: keepRecord

function record = readingOf (record, h)
  if isempty (record) || ~isfield (record, 'status') || ...
     ~any (strcmp (record.status, {'ok', 'invalid'}))
    return
  end
  fields = {'funs', 'status', 'message', 'cause', 'results'};
  all = {record};
  if isfield (record, 'readings')
    all = [all, num2cell(reshape (record.readings, 1, []))];
  end
  % one of fewer results was asked for another number of targets
  fits = @(r) strcmp (r.funs, h.funs) && ...
              (isempty (r.results) || numel (r.results) == h.count);
  k = find (cellfun (fits, all), 1);
  if isempty (k)
    all{end + 1} = struct ('funs', '', 'status', 'ended', 'message', '', ...
                           'cause', '', 'results', zeros (1, 0));
    k = numel (all);
  end
  for name = fields
    record.(name{1}) = all{k}.(name{1});
  end
end

%!test
%! of = @(funs, z) struct ('funs', funs, 'status', 'ok', 'message', '', ...
%!                         'cause', '', 'results', z);
%! h = @(funs, n) struct ('funs', funs, 'count', n);
%! r = setfield (of ('x', [1, 2]), 'readings', [of('y', 3), of('z', 4)]);
%! assert (readingOf (r, h ('x', 2)).results, [1, 2]);
%! assert (readingOf (r, h ('z', 1)).results, 4);
%! for other = {h('w', 1), h('x', 3)}
%!   none = readingOf (r, other{1});
%!   assert ({none.status, none.results, none.funs}, ...
%!           {'ended', zeros(1, 0), ''});
%! end
%! % what holds for every question; a job
%! for status = {'forgotten', 'failed', 'timeout'}
%!   r.status = status{1};
%!   assert (readingOf (r, h ('w', 1)), r);
%! end
%! assert (readingOf (struct ('key', 'k'), h ('x', 1)), struct ('key', 'k'));
%! assert (readingOf ([], h ('x', 1)), []);

% SPDX-License-Identifier: GPL-3.0-only
