% WRITEGAPHEAD  Writes lines of a data.head with the effect that was found.
%
% CALL: writeGapHead (PAGE)
%
%   PAGE  see pageData
%
% gap/calibrated.head: the model variables, the parameters as they were fitted
% together with the effect (howFar), and the effect's variables at the median of
% their posterior. Not written where no cure was tried.
%
% See also: writePage, writeGapJson

function writeGapHead (page)
  gap = page.sources.gap;
  effect = jsonAt (gap, {'howFar', 'effect'});
  params = jsonAt (gap, {'howFar', 'params'});
  if ~ischar (effect) || isempty (effect) || ~isstruct (params)
    return
  end
  v = page.Case.modelVars;
  values = zeros (1, numel (page.Case.names));
  for j = 1:numel (values)
    both = jsonAt (params, {page.Case.names{j}});
    if numel (both) < 2
      return
    end
    values(j) = both(2);
  end
  v = designVariables (v, values, page.Case.names);
  strength = jsonAt (gap, {'which', 'strength', effect});
  for k = 1:numel (page.Case.effectVars)
    median = jsonAt (strength, page.Case.effectVars(k));
    if ~isempty (median)
      v.(page.Case.effectVars{k}) = median(1);
    end
  end
  text = sprintf (['# parameters fitted with %s, which is at the median ', ...
                   'of its posterior\n'], effect);
  writeAtomic (fullfile (page.Case.folder, 'gap', 'calibrated.head'), ...
               [text, headLines(v)]);
end

%!test
%! page.Case = struct ('modelVars', struct (), 'names', {{'a'}}, ...
%!                     'effectVars', {{'cohesionPP'}}, 'folder', tempname ());
%! mkdir (page.Case.folder);
%! mkdir (fullfile (page.Case.folder, 'gap'));
%! page.sources.gap = jsondecode (['{"which": {"strength": {"cohesion": ', ...
%!   '{"cohesionPP": [5, 4, 6]}}}, "howFar": {"effect": "cohesion", ', ...
%!   '"params": {"a": [1, 2]}}}']);
%! writeGapHead (page);
%! v = headDefaults (fullfile (page.Case.folder, 'gap', 'calibrated.head'));
%! assert (v, struct ('a', 2, 'cohesionPP', 5));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (page.Case.folder, 's');
