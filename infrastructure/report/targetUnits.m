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
  units = repmat ({''}, 1, numel (Case.targets));
  for t = 1:numel (Case.targets)
    T = Case.targets(t);
    if isfield (T, 'unit') && ischar (T.unit)
      units{t} = T.unit;
    end
    if isempty (units{t})
      units{t} = unitOfModel (Case.models(T.model).folder, T.index);
    end
  end
end

function unit = unitOfModel (folder, index)
  unit = '';
  info = resultInfo (folder);
  if numel (info) >= index && ~strcmp (info(index).unit, '-')
    unit = info(index).unit;
  end
end

%!test
%! Case.models = struct ('folder', {'', fullfile(fileparts (which ( ...
%!   'DEcalioc')), 'DEMmodels', 'Heap')});
%! Case.targets = struct ('model', {1, 2}, 'index', {1, 2});
%! assert (targetUnits (Case), {'', 'm'});
%! [Case.targets.unit] = deal ('', 'mm');
%! assert (targetUnits (Case), {'', 'mm'});
