% PARAMETERWORDS  What each design variable is, in words, with its unit.
%
% CALL: LABELS = parameterWords (CASE)
%
%   CASE    see newCase
%   LABELS  1 x d cell: 'friction between grains', 'lid mass (kg)'; '' where
%           nobody says it
%
% From the remark behind the variable in data.head of a model (unit, words),
% else from the names that the models of the toolbox use.

function labels = parameterWords (Case)
  labels = cell (1, numel (Case.names));
  folders = {Case.models.folder};
  heads = cellfun (@checkHead, folders(~cellfun (@isempty, folders)), ...
                   'UniformOutput', false);
  heads = [heads{:}];
  for j = 1:numel (labels)
    labels{j} = usualWords (Case.names{j});
    remarks = {};
    if ~isempty (heads)
      remarks = {heads(strcmp ({heads.name}, Case.names{j})).remark};
    end
    words = regexp (remarks, '^([^,]*),[ \t]*(.+)$', 'tokens', 'once');
    words = words(~cellfun (@isempty, words));
    if ~isempty (words)
      labels{j} = withUnit (strtrim (words{1}{2}), strtrim (words{1}{1}));
    end
  end
end

function text = usualWords (name)
  known = {'density', 'density of %s (kg/m3)'; 'radius', 'radius of %s (m)'; ...
           'youngsModulus', 'Young''s modulus of %s (Pa)'; ...
           'poissonsRatio', 'Poisson''s ratio of %s'; ...
           'coefRestitution', 'restitution %s'; ...
           'coefRollingFriction', 'rolling friction %s'; ...
           'coefFriction', 'friction %s'; ...
           'cohesion', 'cohesion energy density %s (J/m3)'};
  ends = {'PP', 'between grains'; 'PW', 'of grains and walls'; ...
          'P', 'the grains'; 'W', 'the walls'};
  text = '';
  for k = 1:rows (known)
    for e = 1:rows (ends)
      if strcmp (name, [known{k, 1}, ends{e, 1}])
        text = sprintf (known{k, 2}, ends{e, 2});
      end
    end
  end
end

%!test
%! folder = tempname ();
%! mkdir (folder);
%! writeAtomic (fullfile (folder, 'data.head'), ...
%!   ["variable lid equal 2 # kg, mass of the lid\n", ...
%!    "variable radiusP equal 1  # m\nvariable a equal 1\n"]);
%! Case = struct ('names', {{'lid', 'radiusP', 'coefFrictionPW', 'a'}}, ...
%!                'models', struct ('folder', {folder, ''}));
%! assert (parameterWords (Case), {'mass of the lid (kg)', ...
%!   'radius of the grains (m)', 'friction of grains and walls', ''});
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');
