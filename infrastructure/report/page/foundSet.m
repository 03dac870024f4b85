% FOUNDSET  The best set of a report so far.
%
% CALL: P = foundSet (PAGE)
%
%   PAGE  see pageData
%   P     1 x d, from calibration.json, else progress.json; 0 x d: none yet
%
% See also: pageData

function p = foundSet (page)
  names = page.Case.names;
  p = zeros (0, numel (names));
  for source = {'calibration', 'progress'}
    params = jsonAt (page.sources, {source{1}, 'params'});
    if isstruct (params) && all (isfield (params, names)) && isempty (p)
      p = cellfun (@(n) params.(n), names);
    end
  end
end

%!test
%! page.Case.names = {'a', 'b'};
%! page.sources = struct ('calibration', [], 'progress', ...
%!   struct ('params', struct ('b', 2, 'a', 1)));
%! assert (foundSet (page), [1, 2]);
%! page.sources.progress = [];
%! assert (size (foundSet (page)), [0, 2]);
