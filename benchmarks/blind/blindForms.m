% BLINDFORMS  What the sealed laboratory can do that the library does otherwise.
%
% CALL: FORMS = blindForms ()
%
%   FORMS  1 x F struct:
%     name      text
%     effect    name of the listed effect that it is another form of, '' where
%               the cause is on no list
%     variable  variable of data.head that holds its strength ('': none)
%     factor    value of the variable = FACTOR x that of the library at the same
%               strength (forms of an effect)
%     range     1 x 2, values to draw from (causes on no list)
%     patch     handle, LINES = PATCH (VALUE): cell of shell commands that turn
%               a copy of a bench into the laboratory's, before it runs
%
% Sources: LIGGGHTS 3.8 has SJKR2 (twice the contact area of SJKR for small
% overlaps), the bridges of Washino beside those of Easo, CDT beside EPSD2 and
% Hooke beside Hertz. Drag by the square of the speed is Newton's law.
%
% slotsByLength and widerBatch (all sizes off, and not alike), wideSizes, wet
% and stickyWalls are for drum and slot bins, where the last three are on no
% list.
%
% Clumps of three and four spheres give no heap: LIGGGHTS 3.8 takes a clump that
% crosses the edge of the box apart, and its members overlap. That bench counts
% as not measured then.
%
% See also: blind, blindDraw, clumpLines

function forms = blindForms ()
  law = 'effects/material.inc effects/cohesion.inc effects/liquid.inc';
  squared = @(v) swap ('cohesion sjkr ', 'cohesion sjkr2 ', law);
  plain = '\(variable law string.*epsd2\)';
  damped = '\1 tangential_damping off';
  table = {'sjkr2', 'cohesion', 'cohesionPP', 0.5, squared; ...
           'wallSjkr2', 'wallAdhesion', 'cohesionPW', 0.5, squared; ...
           'washino', 'liquidBridge', 'liquidContent', 1, ...
           @(v) swap('easo', 'washino', law); ...
           'fiveSizes', 'sizeSpread', 'sizeSpread', 1, @(v) fiveSizes(); ...
           'threeSpheres', 'shape', 'clumpAspect', 1, ...
           @(v) clumpLines(3, v); ...
           'fourSpheres', 'shape', 'clumpAspect', 1, ...
           @(v) clumpLines(4, v); ...
           'squareDrag', 'drag', 'dragRate', 1 / 0.3, @squareDrag; ...
           'slowVibration', 'vibration', 'vibrationStrength', 1, ...
           @(v) addLine('vibrationFrequency equal 35'); ...
           'normalDamping', 'restitution', 'dampingFactor', 1, ...
           @(v) swap(plain, damped, law); ...
           'cdt', '', '', [1, 1], ...
           @(v) swap('rolling_friction epsd2', 'rolling_friction cdt', ...
                     law); ...
           'hooke', '', '', [1, 1], @(v) hooke(law); ...
           'gluedCloser', '', '', [1, 1], @(v) gluedCloser(); ...
           'partRough', '', '', [1, 1], @(v) partRough(); ...
           'soft', '', 'stiffnessFactor', [0.3, 0.7], @(v) {}; ...
           'overfilled', '', 'fillFactor', [1.05, 1.25], @(v) {}; ...
           'slotsByLength', 'opening', '', 1, @slotsByLength; ...
           'widerBatch', 'meanSize', 'sizeFactor', 1, ...
           @(v) addLine('sizeSpread equal 0.12'); ...
           'wideSizes', '', 'sizeSpread', [0.12, 0.2], @(v) {}; ...
           'wet', '', 'liquidContent', [0.002, 0.01], @(v) {}; ...
           'stickyWalls', '', 'cohesionPW', [2e4, 6e4], @(v) {}};
  for i = 1:rows (table)
    forms(i) = struct ('name', table{i, 1}, 'effect', table{i, 2}, ...
                       'variable', table{i, 3}, 'factor', table{i, 4}(1), ...
                       'range', table{i, 4}([1, end]), ...
                       'patch', table{i, 5});
  end
end

function lines = swap (from, to, files)
  lines = {sprintf('sed -i "s/%s/%s/" %s', from, to, files)};
end

function lines = addLine (text)
  lines = {sprintf('echo "variable %s" >> data.head', text)};
end

% Both slots by the same length, that of the factor at their mean.
function lines = slotsByLength (factor)
  wider = 0.025 * (factor - 1);
  lines = [addLine(sprintf ('slot1 equal %.6g', 0.02 + wider)), ...
           addLine(sprintf ('slot2 equal %.6g', 0.03 + wider))];
end

function lines = gluedCloser ()
  lines = {'sed -i "s/v_cellWidth \/ 3/v_cellWidth \/ 4/" in.*', ...
           'sed -i "s/8 \/ 3 \* v_radiusP/2.1 * v_radiusP/" in.*', ...
           'echo "variable glueColumns equal 4" >> data.head'};
end

% Radii 1 -/+ s and 1 -/+ 2 s, weights of a binomial: standard deviation s.
function lines = fiveSizes ()
  names = {'tA', 'tB', 'tC', 'tD', 'tE'};
  seeds = primes (32500000)(end - 4:end);
  weights = [1, 4, 6, 4, 1] / 16;
  text = {};
  parts = '';
  for i = 1:5
    text{end + 1} = sprintf (['variable r%s equal \\"v_radiusG * ' ...
                              '(1 + %d * v_sizeSpread)\\"'], ...
                             names{i}, i - 3);
    text{end + 1} = sprintf (['fix %s all particletemplate/sphere %d ' ...
                              'atom_type 1 density constant \\${densityG} ' ...
                              'radius constant \\${r%s}'], ...
                             names{i}, seeds(i), names{i});
    parts = sprintf ('%s %s %g', parts, names{i}, weights(i));
  end
  text{end + 1} = ['fix grains all particledistribution/discrete/' ...
                   'numberbased 49979687 5', parts];
  text = [text, {'variable integrator string nve/sphere', ...
                 'variable integratorGroup string loose', ...
                 'variable members equal 1'}];
  lines = {sprintf('printf "%%s\\n" %s > %s', ...
                   sprintf ('"%s" ', text{:}), 'effects/spheres.inc')};
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

function lines = hooke (law)
  fix_ = ['fix mSpeed all property/global characteristicVelocity ' ...
          'scalar 0.5'];
  lines = {sprintf('sed -i "s/model hertz/model hooke/" %s', law), ...
           sprintf('sed -i "1i %s" effects/material.inc', fix_)};
end

% Glued grains on the first 0.14 m of the floor and the inner part of the plate.
function lines = partRough ()
  lines = {['sed -i "s/region glue block 0 \${runway}/region glue block 0 ' ...
            '0.14/" in.*'], ...
           'sed -i "s/v_plateRadius - v_radiusP/0.85 * v_plateRadius/" in.*'};
end

%!test % names are different, forms of an effect name one of the library
%! forms = blindForms ();
%! assert (numel (unique ({forms.name})), numel (forms));
%! known = listEffects ();
%! own = {forms.effect};
%! assert (all (ismember (own(~strcmp (own, '')), known)));
%!test % every patch changes the bench that it is meant for
%! root = startBenchmarks ();
%! for form = blindForms ()
%!   changed = false;
%!   for bench = {'Collapse', 'Heap', 'SlotBin'}
%!     source = fullfile (root, 'DEMmodels', bench{1});
%!     folder = tempname ();
%!     system (sprintf ('cp -rL "%s" "%s"', source, folder));
%!     lines = form.patch (0.1 + strcmp (form.effect, 'shape'));
%!     if isempty (lines)
%!       changed = true;
%!       continue
%!     end
%!     text = strjoin ([{sprintf('cd "%s"', folder)}, lines], "\n");
%!     assert (system (text), 0);
%!     [~, out] = system (sprintf ('diff -rq "%s" "%s"', source, folder));
%!     changed = changed || ~isempty (out);
%!     confirm_recursive_rmdir (false, 'local');
%!     rmdir (folder, 's');
%!   end
%!   assert (changed, form.name);
%! end
