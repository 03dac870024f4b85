% SWAPFORMS  Causes whose law is another one than that of the listed effect.
%
% CALL: FORMS = swapForms ()
%
%   FORMS  1 x F struct:
%     name    text
%     cause   cellstr, listed effects that the cause belongs to
%     values  handle, V = VALUES (S, ROOM): struct of variables of data.head at
%             the strength S in [0, 1]; ROOM struct rolling, sliding: what their
%             limits leave above the reference
%     lines   handle, LINES = LINES (S): shell commands that turn a copy of a
%             bench into the laboratory's, before it runs
%
% With one of these grains or contacts differ from those of the reference:
% bridges of a liquid ten times as viscous as water; bridges beside more
% rolling resistance; bridges by the law of Washino; attraction that pulls when
% grains part (DMT) and SJKR2, where SJKR is listed; rolling resistance of the
% kind CDT; clumps of three and four spheres; friction without memory; drag that
% grows with the square of the speed.
%
% See also: lawSwap

function forms = swapForms ()
  none = @(s) {};
  sed = @(from, to) {sprintf('sed -i "s/%s/%s/" effects/*.inc', from, to)};
  water = @(s) 0.0005 + 0.006 * s;
  drag = 0.3 + 2.2 * [0, 1];
  table = {'viscousBridges', {'liquidBridge'}, ...
           @(s, room) struct('liquidContent', water(s), 'liquidViscosity', 0.01), ...
           none; ...
           'bridgesRolling', {'liquidBridge', 'rolling'}, ...
           @(s, room) struct('liquidContent', water(s), ...
                             'rollingAdded', s * room.rolling), none; ...
           'washino', {'liquidBridge'}, ...
           @(s, room) struct('liquidContent', water(s)), ...
           @(s) sed('easo', 'washino'); ...
           'dmt', {'cohesion'}, ...
           @(s, room) struct('adhesionPP', 0.03 + 0.17 * s), none; ...
           'sjkr2', {'cohesion'}, ...
           @(s, room) struct('cohesionPP', 5e3 + 2.5e4 * s), ...
           @(s) sed('cohesion sjkr ', 'cohesion sjkr2 '); ...
           'cdt', {'rolling'}, ...
           @(s, room) struct('rollingAdded', s * room.rolling), ...
           @(s) sed('rolling_friction epsd2', 'rolling_friction cdt'); ...
           'threeSpheres', {'shape'}, @(s, room) struct(), ...
           @(s) clumpLines(3, 1.1 + 0.4 * s); ...
           'fourSpheres', {'shape'}, @(s, room) struct(), ...
           @(s) clumpLines(4, 1.1 + 0.4 * s); ...
           'noMemory', {'sliding'}, ...
           @(s, room) struct('slidingAdded', s * room.sliding), ...
           @(s) sed('tangential history', 'tangential no_history'); ...
           'squareDrag', {'drag'}, @(s, room) struct(), ...
           @(s) squareDrag((drag(1) + s * diff (drag)) / 0.3); ...
           'nothing', {}, @(s, room) struct(), none};
  forms = cell2struct (table, {'name', 'cause', 'values', 'lines'}, 2)';
end

% acceleration = - value x speed x velocity
function lines = squareDrag (value)
  text = {sprintf('variable dragSpeed atom sqrt(vx*vx+vy*vy+vz*vz)')};
  for axis_ = 'xyz'
    text{end + 1} = sprintf (['variable drag%s atom ' ...
                              '-%.6g*mass*v_dragSpeed*v%s'], ...
                             axis_, value, axis_);
  end
  text{end + 1} = 'fix drag loose addforce v_dragx v_dragy v_dragz';
  lines = {'sed -i "/fix drag loose viscous/d" effects/forces.inc', ...
           sprintf('printf "%%s\\n" %s >> effects/forces.inc', ...
                   sprintf ('"%s" ', text{:}))};
end

% Shell commands that write effects/clumps.inc: three spheres in a row, length / width
% ASPECT (1 to 2), or a tetrahedron with an edge of 2 (ASPECT - 1) radii of a member.
% Volume and density of the sphere that a grain stands for are kept. In a row the outer
% two overlap inside the middle one only: three spheres less two lenses.
function lines = clumpLines (n, aspect)
  if n == 3
    step = aspect - 1;
    centre = [-step, 0, 0; 0, 0, 0; step, 0, 0];
    volume = 3 - 2 * lens (step);
  else
    centre = [1, 1, 1; 1, -1, -1; -1, 1, -1; -1, -1, 1] / sqrt (8) * ...
         2 * (aspect - 1);
    volume = countedVolume (centre);
  end
  scale = volume^(-1 / 3);                  % radius of a member / of the sphere
  text = {sprintf('variable rC equal %.8g*\\${radiusG}', scale)};
  spheres = '';
  for i = 1:n
    for j = 1:3
      text{end + 1} = sprintf ('variable c%d%d equal %.8g*\\${radiusG}', ...
                               i, j, scale * centre(i, j));
    end
    spheres = sprintf ('%s \\${c%d1} \\${c%d2} \\${c%d3} \\${rC}', spheres, ...
                       i, i, i);
  end
  text{end + 1} = sprintf (['fix tM all particletemplate/multisphere ' ...
                            '15485867 atom_type 1 density constant ' ...
                            '\\${densityG} nspheres %d ntry 1000000 ' ...
                            'spheres%s type 1'], n, spheres);
  text{end + 1} = ['fix grains all particledistribution/discrete/' ...
                   'numberbased 49979687 1 tM 1.0'];
  text{end + 1} = ['variable integrator string \"multisphere ' ...
                   'allow_group_and_set yes\"'];
  text = [text, {'variable integratorGroup string all', ...
                 sprintf('variable members equal %d', n)}];
  lines = {sprintf('printf "%%s\\n" %s > effects/clumps.inc', ...
                   sprintf ('"%s" ', text{:}))};
end

% Share of its volume that a unit sphere has in common with one this far away.
function share = lens (distance)
  share = (4 + distance) * (2 - distance)^2 / 16;
end

% In volumes of a member, of radius 1.
function volume = countedVolume (centre)
  reach = 1 + max (abs (centre(:)));
  n = 120;
  line = ((1:n) - 0.5) / n * 2 * reach - reach;
  [x, y, z] = ndgrid (line, line, line);
  inside = false (size (x));
  for i = 1:rows (centre)
    inside = inside | (x - centre(i, 1)).^2 + (y - centre(i, 2)).^2 + ...
                      (z - centre(i, 3)).^2 < 1;
  end
  volume = mean (inside(:)) * (2 * reach)^3 / (4 / 3 * pi);
end

%!test
%! % each changes a bench, and names effects that are listed
%! root = startBenchmarks ();
%! known = [listEffects(), {'sliding', 'rolling'}];
%! room = struct ('rolling', 0.1, 'sliding', 0.2);
%! head = headDefaults (fullfile (root, 'DEMmodels', 'Collapse', 'data.head'));
%! for form = swapForms ()
%!   assert (all (ismember (form.cause, known)));
%!   set = form.values(0.5, room);
%!   assert (all (ismember (fieldnames (set), ...
%!                          [fieldnames(head); {'slidingAdded'}])));
%!   assert (strcmp (form.name, 'nothing') || ~isempty (fieldnames (set)) || ...
%!           ~isempty (form.lines(0.5)), form.name);
%! end

%!test
%! % two spheres that touch; a tetrahedron of spheres that just overlap: between one and four
%! forms = swapForms ();
%! of = @(name, s) forms(strcmp ({forms.name}, name)).lines(s){1};
%! assert (~isempty (strfind (of ('threeSpheres', (1e-9 - 0.1) / 0.4), 'equal 1*')));
%! text = of ('fourSpheres', 0.75);
%! scale = str2double (regexp (text, 'rC equal ([\d.]+)', 'tokens', 'once'){1});
%! assert (scale < 1 && scale > 4^(-1 / 3));

% SPDX-License-Identifier: GPL-3.0-only
