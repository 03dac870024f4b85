% WRITEGAPHEAD  Writes lines of a data.head with the effect that was found.
%
% CALL: writeGapHead (GAP, CASE)
%
%   GAP   decoded gap/gap.json;  CASE  see newCase
%
% gap/calibrated.head: the model variables, and the parameters and variables of
% the effect (or pair) as they were fitted together (howFar). Not written where
% no cure was tried.
%
% See also: diagnoseCase, writeGapJson

function writeGapHead (gap, Case)
  effect = jsonAt (gap, {'howFar', 'effect'});
  params = jsonAt (gap, {'howFar', 'params'});
  values = jsonAt (gap, {'howFar', 'values'});
  if ~ischar (effect) || isempty (effect) || ~isstruct (params) || ...
     ~isstruct (values)
    return
  end
  v = Case.modelVars;
  set = zeros (1, numel (Case.names));
  for j = 1:numel (set)
    both = jsonAt (params, {Case.names{j}});
    if numel (both) < 2
      return
    end
    set(j) = both(2);
  end
  v = designVariables (v, set, Case.names);
  for name = fieldnames (values)'
    v.(name{1}) = values.(name{1});
  end
  text = sprintf ("# parameters fitted together with %s\n", effect);
  writeAtomic (fullfile (Case.folder, 'gap', 'calibrated.head'), ...
               [text, headLines(v)]);
end

%!test % a pair: the variables of both, at the strength of the cure
%! Case = struct ('modelVars', struct (), 'names', {{'a'}}, ...
%!                     'folder', tempname ());
%! mkdir (Case.folder);
%! mkdir (fullfile (Case.folder, 'gap'));
%! gap = jsondecode (['{"howFar": {"params": {"a": [1, 2]}, ', ...
%!   '"effect": "cohesion + drag", ', ...
%!   '"values": {"cohesionPP": 5, "dragRate": 2}}}']);
%! writeGapHead (gap, Case);
%! v = headDefaults (fullfile (Case.folder, 'gap', 'calibrated.head'));
%! assert (v, struct ('a', 2, 'cohesionPP', 5, 'dragRate', 2));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (Case.folder, 's');
