% TARGETUNITS  The unit of each target, where the case or its model gives it.
%
% CALL: UNITS = targetUnits (CASE)
%
%   CASE   see newCase
%   UNITS  1 x T cell of texts; '' where it is not known
%
% Taken from the field unit of the target, else from the model's results.csv.
%
% See also: resultInfo

function units = targetUnits (Case)
  units = {targetInfo(Case).unit};
  units(strcmp (units, '-')) = {''};
  for t = 1:numel (Case.targets)
    T = Case.targets(t);
    if isfield (T, 'unit') && ischar (T.unit) && ~isempty (T.unit)
      units{t} = T.unit;
    end
  end
end

%!test
%! Case.models = struct ('folder', {'', fullfile(fileparts (which ( ...
%!   'DEcalioc')), 'DEMmodels', 'Heap')});
%! Case.targets = struct ('model', {1, 2}, 'index', {1, 2});
%! assert (targetUnits (Case), {'', 'm'});
%! [Case.targets.unit] = deal ('', 'mm');
%! assert (targetUnits (Case), {'', 'mm'});
