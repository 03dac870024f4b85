% WRITEGAPHEAD  Writes lines of a data.head with the effect that was found.
%
% CALL: writeGapHead (PAGE)
%
%   PAGE  see pageData
%
% gap/calibrated.head: the model variables, and the parameters and variables of
% the effect (or pair) as they were fitted together (howFar). Not written where
% no cure was tried.
%
% See also: writePage, writeGapJson

function writeGapHead (page)
  gap = page.sources.gap;
  effect = jsonAt (gap, {'howFar', 'effect'});
  params = jsonAt (gap, {'howFar', 'params'});
  values = jsonAt (gap, {'howFar', 'values'});
  if ~ischar (effect) || isempty (effect) || ~isstruct (params) || ...
     ~isstruct (values)
    return
  end
  v = page.Case.modelVars;
  set = zeros (1, numel (page.Case.names));
  for j = 1:numel (set)
    both = jsonAt (params, {page.Case.names{j}});
    if numel (both) < 2
      return
    end
    set(j) = both(2);
  end
  v = designVariables (v, set, page.Case.names);
  for name = fieldnames (values)'
    v.(name{1}) = values.(name{1});
  end
  text = sprintf ("# parameters fitted together with %s\n", effect);
  writeAtomic (fullfile (page.Case.folder, 'gap', 'calibrated.head'), ...
               [text, headLines(v)]);
end

%!test % a pair: the variables of both, at the strength of the cure
%! page.Case = struct ('modelVars', struct (), 'names', {{'a'}}, ...
%!                     'folder', tempname ());
%! mkdir (page.Case.folder);
%! mkdir (fullfile (page.Case.folder, 'gap'));
%! page.sources.gap = jsondecode (['{"howFar": {"params": {"a": [1, 2]}, ', ...
%!   '"effect": "cohesion + drag", ', ...
%!   '"values": {"cohesionPP": 5, "dragRate": 2}}}']);
%! writeGapHead (page);
%! v = headDefaults (fullfile (page.Case.folder, 'gap', 'calibrated.head'));
%! assert (v, struct ('a', 2, 'cohesionPP', 5, 'dragRate', 2));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (page.Case.folder, 's');
