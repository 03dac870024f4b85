% COSTINPUT  What a cost function needs of the case.
%
% CALL: given = costInput (handedOn)
%
% handedOn  cell: what costFunction was handed besides the set and the
%           evaluate function. DEcalioc hands on its case (see newCase); where
%           no cell is one, loadInput.m of the current folder is read
% given     struct: value T x 1 (measured), modelVars, names 1 x d cell,
%           limits 2 x d, WRL (scalar, 0 = no wish for a large time step)
%
% See also: costFunction, newCase, readInput

function given = costInput (handedOn)
  isCase = cellfun (@(c) isstruct (c) && isscalar (c) && ...
                    all (isfield (c, {'targets', 'modelVars', 'options'})), ...
                    handedOn);
  if any (isCase)
    at = find (isCase, 1);
    Case = handedOn{at};
    given = struct ('value', [Case.targets.value]', ...
                    'modelVars', Case.modelVars, 'names', {Case.names}, ...
                    'limits', Case.limits, 'WRL', Case.options.WRL);
    return
  end
  raw = readInput ();
  given = struct ('value', asColumn (raw.optim.targetVal), ...
                  'modelVars', raw.modelVars, 'names', {raw.assign(:)'}, ...
                  'limits', raw.paramLims, 'WRL', 0);
  if isfield (raw.optim, 'WRL') && ~isempty (raw.optim.WRL)
    given.WRL = raw.optim.WRL;
  end
end

%!test
%! Case = newCase (standInCase (tempname ()));
%! given = costInput ({{'KM_fun_1'}, Case});
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (Case.folder, 's');
%! assert (given.value, [400; 0.025; 3]);
%! assert (given.names, {'a', 'b'});
%! assert (given.WRL, 0);
%!test
%! % the toolbox's own case
%! given = costInput ({});
%! assert (given.value, [400; 0.025]);
%! assert (given.WRL, 0.5);
